#include "sandbox/load_times.h"

#include "core/parallel.h"
#include "image/codec.h"
#include "render/gpu_scene.h"
#include "sandbox/median.h"
#include "scene/gltf.h"
#include "scene/gltf_draco.h"
#include "scene/gltf_meshopt.h"
#include "scene/gltf_parse.h"
#include "scene/gltf_resources.h"
#include "scene/gltf_source.h"
#include "scene/planet.h"

#include <chrono>
#include <ctime>
#include <memory>
#include <vector>

namespace alpenglow {

namespace {

struct Samples {
    std::vector<double> wall_ms, cpu_ms;

    LoadTimes::Step medians() const { return {median(wall_ms), median(cpu_ms)}; }
};

double cpu_ms() { return 1e3 * static_cast<double>(std::clock()) / CLOCKS_PER_SEC; }

/// Notes how long `work` takes and returns what it returns: to free that is no part of the time.
auto timed(Samples& samples, auto const& work) {
    auto const start = std::chrono::steady_clock::now();
    double const cpu_start = cpu_ms();
    auto result = work();
    samples.cpu_ms.push_back(cpu_ms() - cpu_start);
    samples.wall_ms.push_back(
        std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start).count());
    return result;
}

/// A scene's bytes as plain as they get without an importer.
struct Decoded {
    gltf::Document document;
    std::vector<ByteImage> pictures;
    std::vector<DeepImage> deep_pictures;
};

/// Trusts the file: load_gltf must have passed it.
Decoded read_and_decode(std::filesystem::path const& file, GltfOptions const& options) {
    std::vector<GltfDiagnostic> warnings;
    gltf::Report report(file, options.limits, warnings);
    gltf::Source source = gltf::read_source(report);
    Decoded decoded{gltf::parse_document(source.json, options.scene_index, report), {}, {}};
    gltf::Document& document = decoded.document;
    document.buffers = gltf::read_buffers(source, report);
    gltf::decompress_views(document, source.json, report);
    gltf::decompress_primitives(document, report);
    decoded.pictures.resize(document.images.size());
    decoded.deep_pictures.resize(document.images.size());
    parallel_for(static_cast<int>(document.images.size()), 0, [&](int i) {
        auto const n = static_cast<std::size_t>(i);
        std::vector<std::byte> const bytes = gltf::read_image_bytes(document, n, report);
        if (read_picture_header(bytes).bits == 16)
            decoded.deep_pictures[n] = decode_deep_picture(bytes);
        else
            decoded.pictures[n] = decode_picture(bytes);
    });
    return decoded;
}

} // namespace

LoadTimes time_loading(Device const& device, std::filesystem::path const& file, View const& view, int rounds,
                       std::function<void()> const& before_round) {
    GltfOptions const options{.largest_texture = view.settings.largest_texture,
                              .scene_index = view.scene_index,
                              .limits = gltf_limits(view.settings)};
    double const planet_radius = load_planet(view.planet).radius;
    auto const load = [&] { return load_gltf(file, options); };
    auto const load_and_upload = [&] {
        return std::make_unique<GpuScene>(device, load(), scene_placement(view), planet_radius);
    };
    LoadTimes times;
    Samples reading, loading, uploading;
    for (int round = 0; round < LOAD_WARM_UP_ROUNDS + rounds; ++round) {
        before_round();
        if (round == LOAD_WARM_UP_ROUNDS) reading = loading = uploading = {};
        Scene const scene = timed(loading, load);
        times.triangles = triangle_count(scene);
        times.pictures = scene.pictures.size();
        timed(reading, [&] { return read_and_decode(file, options); });
        timed(uploading, load_and_upload);
    }
    times.read_and_decode = reading.medians();
    times.load = loading.medians();
    times.load_and_upload = uploading.medians();
    return times;
}

} // namespace alpenglow
