#include "core/error.h"
#include "core/files.h"
#include "scene/gltf.h"
#include "support/mutator.h"
#include "support/sound_scene.h"
#include "support/temporary_folder.h"

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <span>

// An input is a file: a .gltf, a .glb or neither. It is loaded as the program loads it, pictures included.

using namespace alpenglow;

namespace {

constexpr std::size_t glb_json_begin = 20; // after the file's header and the first chunk's

bool is_glb(std::string const& file) { return file.size() > glb_json_begin && file.starts_with("glTF"); }

/// Damage that knows what it damages: values of JSON, chunks of a .glb. Nothing where the file is neither.
std::string knowing_mutation(std::string const& file, unsigned seed) {
    test::Mutator mutator(seed);
    try {
        return is_glb(file) ? mutator.glb(file) : mutator.json(file);
    } catch (nlohmann::json::exception const&) {
        return {};
    }
}

/// Limits at which no input takes long: what is larger only takes time and memory in proportion.
GltfOptions quick() {
    GltfOptions options;
    options.limits.largest_scene_file = 8;
    options.limits.most_json_values = 200'000;
    options.limits.most_instances = 10'000;
    options.limits.most_vertices = options.limits.most_indices = 1 << 20;
    options.limits.most_pixels = 1;
    return options;
}

void expect_sound(Scene const& scene) {
    std::string const fault = test::fault_of(scene);
    if (fault.empty()) return;
    std::fprintf(stdout, "the scene has %s\n", fault.c_str());
    std::abort();
}

} // namespace

extern "C" std::size_t LLVMFuzzerMutate(std::uint8_t* data, std::size_t size, std::size_t most);

extern "C" std::size_t LLVMFuzzerCustomMutator(std::uint8_t* data, std::size_t size, std::size_t most, unsigned seed) {
    bool const as_bytes = seed % 2 == 0;
    if (as_bytes) return LLVMFuzzerMutate(data, size, most);
    std::string const changed = knowing_mutation({reinterpret_cast<char const*>(data), size}, seed);
    if (changed.empty() || changed.size() > most) return LLVMFuzzerMutate(data, size, most);
    std::ranges::copy(changed, data);
    return changed.size();
}

extern "C" int LLVMFuzzerTestOneInput(std::uint8_t const* data, std::size_t size) {
    static test::TemporaryFolder const folder;
    std::filesystem::path const file = folder.path() / "scene.gltf";
    write_file(file, std::as_bytes(std::span(data, size)));
    GltfSummary summary;
    try {
        Scene scene = load_gltf(file, quick(), &summary);
        expect_sound(scene);
        constexpr double planet_radius = 6.36e6; // [m]
        curve_to_planet(scene, planet_radius, 1);
        expect_sound(scene);
    } catch (Error const& error) {
        if (error.kind() != ErrorKind::bad_input) std::abort();
    }
    return 0;
}
