#pragma once

#include <filesystem>
#include <utility>

namespace alpenglow {

/// A .gltf file of 500 000 triangles with four materials of two 2048x2048 PNG each, always the same, in a temporary
/// folder that goes away with it.
class BenchScene {
public:
    /// Takes a few seconds. Throws Error(bad_input) where the folder can't be made or written to.
    BenchScene();
    ~BenchScene();
    BenchScene(BenchScene const&) = delete;
    BenchScene& operator=(BenchScene const&) = delete;

    std::filesystem::path file() const { return folder_ / "scene.gltf"; }

private:
    explicit BenchScene(std::filesystem::path folder) : folder_(std::move(folder)) {}

    std::filesystem::path folder_;
};

} // namespace alpenglow
