#include "render/renderer.h"

#include "gpu/transfer.h"
#include "render/frame_constants.h"
#include "render/ground_light.h"
#include "render/models/models.h"
#include "render/passes/exposure.h"

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
                                                          ShadowFit const& shadow, CeilingFit const& ceiling) {
    std::vector<shader::FrameConstants> result;
    for (int i = 0; i < settings.aa; ++i)
        result.push_back(make_frame_constants(world, settings, extent, shadow, ceiling, i));
    return result;
}

} // namespace

Renderer::Renderer(Device const& device, std::uint32_t frames_in_flight)
    : device_(device), executor_(device, frames_in_flight), air_tables_(device), ceiling_(device),
      exposure_(device, table_shape(1, 1), KEPT | VK_IMAGE_USAGE_TRANSFER_DST_BIT, "exposure"),
      seconds_(ADAPTED_AT_ONCE) {
    upload(device, exposure_, bytes_of(shader::ExposureState{1, 0, 0, 0}));
}

Renderer::~Renderer() { vkDeviceWaitIdle(device_.handle()); }

void Renderer::set_scene(Scene const* scene, Placement const& placement, double planet_radius) {
    executor_.wait();
    ceiling_.discard();
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

void Renderer::draw(World const& world, Settings const& settings, Extent extent, Finish const& finish,
                    PresentSync const& sync) {
    size_pictures(extent);
    ShadowFit shadow;
    CeilingFit ceiling_fit;
    if (scene_) {
        ShadowScene const shading{scene_->bounds(), scene_->world_from_scene()};
        ShadowSettings const wanted{settings.cascades, settings.cascade_size, settings.shadow_reach};
        shadow = fit_cascades(shading, world.camera, world.to_sun, wanted);
        int const size = settings.shadows || settings.shafts != "off" ? settings.ceiling_size : 0;
        ceiling_fit = fit_ceiling(shading, scene_->highest_altitude(), world.planet, world.to_sun, size);
    }
    if (!ceiling_.fits(ceiling_fit)) executor_.wait(), ceiling_.replace(ceiling_fit);
    CeilingMap const ceiling = ceiling_.of(ceiling_fit);
    auto const constants = supersample_constants(world, settings, extent, shadow, ceiling_fit);
    AirModel const& model = air_model(settings.model);
    AirTableStore::Kept& tables = air_tables_.of(model);
    shader::Atmosphere const& air = constants.front().atmosphere;
    table_pace_.note(executor_.timings(), model.steps);
    TableWork const work = table_work(tables, air, world.planet.name, settings.spread_tables, table_pace_);
    double const seconds = std::exchange(seconds_, ADAPTED_AT_ONCE);
    GroundAround const ground = scene_ ? ground_around(world, scene_->ground()) : planet_ground(world.planet);
    FrameInputs const inputs{world,  settings,      extent,      scene_.get(), shadow,  ceiling,   constants, model,
                             ground, tables.tables, work.slices, exposure_,    seconds, *mean_,    *picture_};
    FrameGraph graph;
    build_frame(graph, inputs);
    if (finish) finish(graph, graph.find("picture"));
    executor_.submit(graph, sync);
    ceiling_.finish(ceiling_fit);
    finish_work(tables, air, world.planet.name, work);
    tables_finished_ = tables.finished();
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
    return name == "picture" ? picture_.get() : air_tables_.find(name);
}

std::vector<std::byte> Renderer::image_bytes(std::string const& name) {
    executor_.wait();
    GpuImage* const kept = kept_image(name);
    GpuImage* const image = kept ? kept : executor_.transient(name);
    return image ? read_back(device_, *image) : std::vector<std::byte>{};
}

} // namespace alpenglow
