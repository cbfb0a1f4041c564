#pragma once

#include "image/image.h"
#include "interop/exposure.h"
#include "render/air_table_store.h"
#include "render/executor.h"
#include "render/frame.h"
#include "render/rehearsal.h"

#include <functional>
#include <memory>
#include <optional>

namespace alpenglow {

/// When a change of the settings is seen that needs pipelines which nobody has made yet.
enum class Switches {
    at_once,    ///< every picture is of its settings, however long that takes
    when_ready, ///< pictures keep the settings of those before until another thread has made the pipelines, and their
                ///< model of the air until the tables of another are finished, where those are spread over frames
};

/// Draws a world into a picture. Owns what outlives a frame: the tables of the air, the maps of the scene, the mean,
/// the picture, the scene.
class Renderer {
public:
    explicit Renderer(Device const& device, std::uint32_t frames_in_flight = 1, Switches switches = Switches::at_once);
    /// Waits for the device, and for a pipeline that is just being made.
    ~Renderer();

    /// Replaces the scene; nullptr takes it away.
    void set_scene(Scene const* scene, Placement const& placement, double planet_radius);
    GpuScene const* scene() const { return scene_.get(); }

    /// Draws and submits a frame; `picture` and `radiance` wait for it. Tables of the air are made anew when the air
    /// has changed: at once, or over several frames where the setting `spread_tables` says so. Throws Error.
    void draw(World const& world, Settings const& settings, Extent extent);
    /// As `draw`, then lets `finish` add passes behind the picture, such as the panel and the swapchain's image.
    using Finish = std::function<void(FrameGraph&, ImageId picture)>;
    void draw(World const& world, Settings const& settings, Extent extent, Finish const& finish,
              PresentSync const& sync);
    /// Runs `finish` behind the last picture, which is not drawn anew. There must be one.
    void finish_again(Finish const& finish, PresentSync const& sync);
    void wait() { executor_.wait(); }
    /// The next frame makes the tables of its model of the air anew, at once; for measuring.
    void discard_air_tables() { air_tables_.discard(); }
    /// The next frame makes the shadow ceiling and the light on terrain anew; for measuring.
    void discard_scene_maps() { ceiling_.discard(), terrain_.discard(); }
    /// Whether the last picture was of finished tables; another frame goes on with them.
    bool tables_finished() const { return !tables_ || tables_->finished_for(air_); }
    /// Whether those of all models are finished for its air; with `Switches::when_ready` and `spread_tables` frames go
    /// on with them.
    bool tables_ahead_finished() { return !air_tables_.unfinished(air_); }
    /// Whether the last picture has the settings that it was asked for; another frame may.
    bool settings_shown() const { return settings_shown_; }
    /// Whether all pipelines are there that the next switch is likely to need; for measuring.
    bool switches_prepared() { return executor_.prepared(); }
    /// And, where shaders are compiled when they run, whether that is done too.
    bool switches_rehearsed() const { return !rehearsal_ || rehearsal_->idle(); }
    /// How many pipelines frames had to make themselves or to wait for, since the start.
    std::size_t pipelines_missed() const { return executor_.pipelines_missed(); }

    /// Lets the next picture's automatic exposure go on from that of the picture before, `seconds` ago. A picture before
    /// which nobody says so is adapted at once.
    void pass_time(double seconds) { seconds_ = seconds; }
    /// Of the last picture; waits for it.
    shader::ExposureState exposure();

    ByteImage picture();
    FloatImage radiance();
    std::vector<PassTime> const& timings() const { return executor_.timings(); }
    /// Any image of the last frame, as bytes of its format; for tests. Empty where there is none of that name.
    std::vector<std::byte> image_bytes(std::string const& name);

private:
    struct Fits;
    struct Composed;
    Fits fit(World const& world, Settings const& settings) const;
    GroundAround ground_at(glm::dvec3 const& place, Planet const& planet) const;
    Settings const& settings_to_show(World const& world, Settings const& wanted, Extent extent);
    bool prepare(World const& world, Settings const& settings, Extent extent);
    AirTableStore::Kept& tables_to_make(AirTableStore::Kept& read, shader::Atmosphere const& air);
    void prepare_next(FrameGraph const& drawn, World const& world, Extent extent);
    GpuImage* kept_image(std::string const& name);
    void size_pictures(Extent extent);

    Device const& device_;
    Executor executor_;
    std::unique_ptr<GpuScene> scene_;
    AirTableStore air_tables_;
    CeilingStore ceiling_;
    TerrainStore terrain_;
    TablePace table_pace_;
    AirTableStore::Kept const* tables_ = nullptr; ///< of the last picture's model
    AirTableStore::Kept* awaited_ = nullptr;      ///< tables for whose model the next picture does not have it yet
    shader::Atmosphere air_{};                    ///< of the last picture
    Switches switches_;
    std::optional<Settings> shown_;    ///< of the last picture; none: the next one is of its settings
    std::optional<Settings> prepared_; ///< pipelines of what is one choice away from these are made ahead
    bool settings_shown_ = true;
    std::unique_ptr<Rehearsal> rehearsal_; ///< where shaders are compiled when they run and nobody is to notice
    GpuImage exposure_;
    std::unique_ptr<GpuImage> mean_, picture_;
    double seconds_; ///< since the picture before
};

} // namespace alpenglow
