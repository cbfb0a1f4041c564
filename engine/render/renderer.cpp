#include "render/renderer.h"

#include "gpu/transfer.h"
#include "render/atmosphere_constants.h"
#include "render/frame_constants.h"
#include "render/ground_light.h"
#include "render/models/models.h"
#include "render/passes/exposure.h"
#include "render/switches.h"

#include <cstring>
#include <utility>

namespace alpenglow {

namespace {

constexpr VkImageUsageFlags KEPT =
    VK_IMAGE_USAGE_STORAGE_BIT | VK_IMAGE_USAGE_SAMPLED_BIT | VK_IMAGE_USAGE_TRANSFER_SRC_BIT;

ImageShape table_shape(std::uint32_t width, std::uint32_t height) {
    return {VK_FORMAT_R32G32B32A32_SFLOAT, {width, height}};
}

std::vector<shader::FrameConstants> supersample_constants(World const& world, Settings const& settings, Extent extent,
                                                          ShadowFit const& shadow, CeilingFit const& ceiling,
                                                          TerrainFit const& terrain) {
    std::vector<shader::FrameConstants> result;
    for (int i = 0; i < settings.aa; ++i)
        result.push_back(make_frame_constants(world, settings, extent, shadow, ceiling, terrain, i));
    return result;
}

/// Without air, or a model of it that knows how it lights terrain, there is no map.
int terrain_map_size(World const& world, Settings const& settings) {
    bool const lit = world.planet.has_air && !world.studio && air_model(settings.model).sky;
    return lit ? settings.terrain_light_size : 0;
}

} // namespace

/// Where the maps of the scene lie.
struct Renderer::Fits {
    ShadowFit shadow;
    CeilingFit ceiling;
    TerrainFit terrain;
};

/// A frame, and all that its graph refers to.
struct Renderer::Composed {
    Composed(Renderer& by, World const& world, Settings const& settings, Extent extent, Fits const& fits,
             double seconds)
        : ceiling(by.ceiling_.of(fits.ceiling)),
          constants(supersample_constants(world, settings, extent, fits.shadow, fits.ceiling, fits.terrain)),
          read(by.air_tables_.of(air_model(settings.model))),
          spreads(settings.spread_tables && read.planet == world.planet.name),
          made(spreads ? by.tables_to_make(read, constants.front().atmosphere) : read),
          work(table_work(made, constants.front().atmosphere, spreads, by.table_pace_)),
          terrain_cause{fits.terrain, fits.ceiling, constants.front().atmosphere},
          terrain(by.terrain_.of(terrain_cause, !is_ahead() && !work.slices.empty())),
          ground(by.ground_at(world.camera.position, world.planet)),
          terrain_ground(terrain.light_is_new ? by.ground_at(middle(fits.terrain), world.planet) : ground),
          air{read.model, read.tables, {}, {}},
          air_made{made.model, made.tables, made.model.steps(constants.front().atmosphere), work.slices},
          inputs{world, settings, extent, by.scene_.get(), fits.shadow, ceiling, terrain, constants,
                 is_ahead() ? air : air_made, is_ahead() ? &air_made : nullptr, ground, terrain_ground, by.exposure_, seconds,
                 *by.mean_, *by.picture_} {
        build_frame(graph, inputs);
    }
    Composed(Composed const&) = delete;
    Composed& operator=(Composed const&) = delete;

    bool is_ahead() const { return &made != &read; }

    CeilingMap ceiling;
    std::vector<shader::FrameConstants> constants; ///< one for each supersample
    AirTableStore::Kept& read;
    bool spreads; ///< the making of tables over frames
    AirTableStore::Kept& made;
    TableWork work; ///< on those
    TerrainLightCause terrain_cause;
    TerrainMaps terrain;
    GroundAround ground, terrain_ground;
    ModelTables air, air_made;
    FrameInputs inputs;
    FrameGraph graph;
};

Renderer::Renderer(Device const& device, std::uint32_t frames_in_flight, Switches switches)
    : device_(device), executor_(device, frames_in_flight), air_tables_(device), ceiling_(device), terrain_(device), switches_(switches),
      exposure_(device, table_shape(1, 1), KEPT | VK_IMAGE_USAGE_TRANSFER_DST_BIT, "exposure"),
      seconds_(ADAPTED_AT_ONCE) {
    upload(device, exposure_, bytes_of(shader::ExposureState{1, 0, 0, 0}));
    if (switches == Switches::when_ready && device.is_software()) rehearsal_ = std::make_unique<Rehearsal>(device);
}

Renderer::~Renderer() {
    executor_.stop_preparing();
    vkDeviceWaitIdle(device_.handle());
}

void Renderer::set_scene(Scene const* scene, Placement const& placement, double planet_radius) {
    executor_.stop_preparing();
    executor_.wait();
    ceiling_.discard();
    terrain_.discard();
    shown_.reset();
    prepared_.reset();
    scene_ = scene ? std::make_unique<GpuScene>(device_, *scene, placement, planet_radius) : nullptr;
}

void Renderer::size_pictures(Extent extent) {
    if (picture_ && picture_->shape().extent == extent) return;
    executor_.wait();
    mean_ = std::make_unique<GpuImage>(device_, table_shape(extent.width, extent.height), KEPT, "radiance");
    picture_ = std::make_unique<GpuImage>(device_, ImageShape{VK_FORMAT_R8G8B8A8_UNORM, extent}, KEPT, "picture");
}

void Renderer::draw(World const& world, Settings const& settings, Extent extent) {
    draw(world, settings, extent, {}, {});
}

Renderer::Fits Renderer::fit(World const& world, Settings const& settings) const {
    if (!scene_) return {};
    ShadowScene const shading{scene_->bounds(), scene_->world_from_scene()};
    ShadowSettings const wanted{settings.cascades, settings.cascade_size, settings.shadow_reach};
    int const size = settings.shadows || settings.shafts != "off" ? settings.ceiling_size : 0;
    return {fit_cascades(shading, world.camera, world.to_sun, wanted),
            fit_ceiling(shading, scene_->highest_altitude(), world.planet, world.to_sun, size),
            fit_terrain(shading, world.planet, terrain_map_size(world, settings))};
}

/// Of the ground below that place.
GroundAround Renderer::ground_at(glm::dvec3 const& place, Planet const& planet) const {
    return scene_ ? ground_around(planet, place, scene_->ground()) : planet_ground(planet);
}

/// Those that a switch waits for; else the picture's own; behind those, the ones that the next switch may need.
AirTableStore::Kept& Renderer::tables_to_make(AirTableStore::Kept& read, shader::Atmosphere const& air) {
    if (awaited_) return *awaited_;
    bool const leads = settings_shown_ && prepared_ && switches_prepared() && switches_rehearsed();
    AirTableStore::Kept* const next = leads && read.finished_for(air) ? air_tables_.unfinished(air) : nullptr;
    return next ? *next : read;
}

/// Whether all pipelines of such a frame are there. If not, they are being made.
bool Renderer::prepare(World const& world, Settings const& settings, Extent extent) {
    Fits const fits = fit(world, settings);
    Composed const frame(*this, world, settings, extent, fits, 0);
    return executor_.prepare(frame.graph, Need::wanted);
}

/// Those of the last picture as long as pipelines for the others are missing; and its model until the tables of another
/// are finished.
Settings const& Renderer::settings_to_show(World const& world, Settings const& wanted, Extent extent) {
    awaited_ = nullptr;
    if (!shown_ || *shown_ == wanted) return shown_.emplace(wanted);
    Settings next = wanted;
    bool ready = prepare(world, wanted, extent);
    AirTableStore::Kept& tables = air_tables_.of(air_model(wanted.model));
    if (wanted.model != shown_->model && wanted.spread_tables && !tables.finished_for(atmosphere_of(world.planet))) {
        next.model = shown_->model;
        next.show = shown_->show; // a model has images of its own
        if (ready) awaited_ = &tables;
        ready = prepare(world, next, extent);
    }
    if (ready) shown_ = next;
    return *shown_;
}

/// Does ahead what the next switch behind a picture with these passes is likely to need.
void Renderer::prepare_next(FrameGraph const& drawn, World const& world, Extent extent) {
    if (prepared_ && same_choices(*prepared_, *shown_)) return;
    prepared_ = shown_;
    if (rehearsal_) rehearsal_->skip(drawn);
    for (Settings const& next : one_choice_away(*shown_)) {
        Fits const fits = fit(world, next);
        Composed const frame(*this, world, next, extent, fits, 0);
        executor_.prepare(frame.graph, Need::likely);
        if (rehearsal_) rehearsal_->add(frame.graph);
    }
}

void Renderer::draw(World const& world, Settings const& wanted, Extent extent, Finish const& finish,
                    PresentSync const& sync) {
    size_pictures(extent);
    bool const at_once = switches_ == Switches::at_once;
    Settings const& settings = at_once ? wanted : settings_to_show(world, wanted, extent);
    settings_shown_ = settings == wanted;
    Fits const fits = fit(world, settings);
    if (!ceiling_.fits(fits.ceiling)) executor_.wait(), ceiling_.replace(fits.ceiling);
    if (!terrain_.fits(fits.terrain)) executor_.wait(), terrain_.replace(fits.terrain);
    table_pace_.note(executor_.timings(), table_passes());
    Composed frame(*this, world, settings, extent, fits, std::exchange(seconds_, ADAPTED_AT_ONCE));
    if (finish) finish(frame.graph, frame.graph.find("picture"));
    executor_.submit(frame.graph, sync);
    ceiling_.finish(fits.ceiling);
    terrain_.finish(frame.terrain);
    air_ = frame.constants.front().atmosphere;
    finish_work(frame.made, air_, world.planet.name, frame.work);
    tables_ = &frame.read;
    if (!at_once) prepare_next(frame.graph, world, extent);
}

void Renderer::finish_again(Finish const& finish, PresentSync const& sync) {
    FrameGraph graph;
    finish(graph, graph.import(*picture_, "picture", ShowScale::encoded, true));
    executor_.submit(graph, sync);
}

ByteImage Renderer::picture() {
    executor_.wait();
    ByteImage image(picture_->shape().extent);
    std::vector<std::byte> const bytes = read_back(device_, *picture_);
    std::memcpy(image.rgba.data(), bytes.data(), bytes.size());
    return image;
}

FloatImage Renderer::radiance() {
    executor_.wait();
    FloatImage image(mean_->shape().extent);
    std::vector<std::byte> const bytes = read_back(device_, *mean_);
    std::memcpy(image.rgba.data(), bytes.data(), bytes.size());
    return image;
}

shader::ExposureState Renderer::exposure() {
    executor_.wait();
    shader::ExposureState state{};
    std::memcpy(&state, read_back(device_, exposure_).data(), sizeof state);
    return state;
}

GpuImage* Renderer::kept_image(std::string const& name) {
    if (name == "radiance") return mean_.get();
    if (name == "shadow_ceiling") return ceiling_.map();
    if (name == "terrain_light") return terrain_.light();
    if (name == "picture") return picture_.get();
    return tables_ ? tables_->find(name) : nullptr;
}

std::vector<std::byte> Renderer::image_bytes(std::string const& name) {
    executor_.wait();
    GpuImage* const kept = kept_image(name);
    GpuImage* const image = kept ? kept : executor_.transient(name);
    return image ? read_back(device_, *image) : std::vector<std::byte>{};
}

} // namespace alpenglow
