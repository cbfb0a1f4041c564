#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <span>
#include <string>
#include <vector>

namespace alpenglow {

/// The whole file. Throws Error(bad_input) where it is missing, not a regular file, unreadable or larger than
/// `largest` bytes; never blocks on a FIFO or a device.
std::vector<std::byte> read_file(std::filesystem::path const& path, std::uint64_t largest = std::uint64_t{1} << 32);
std::string read_text_file(std::filesystem::path const& path, std::uint64_t largest = std::uint64_t{64} << 20);

/// Writes a temporary file beside `path` and renames it, so that nobody ever sees half a file and a full disk leaves
/// nothing behind. Makes missing parent folders. Throws Error(bad_input).
void write_file(std::filesystem::path const& path, std::span<std::byte const> bytes);
void write_text_file(std::filesystem::path const& path, std::string const& text);

/// Makes the folder (none: the one that the program runs in), and proves that a file can be written there. Throws
/// Error(bad_input).
void require_writable_folder(std::filesystem::path const& folder,
                             std::string const& advice = "choose another output folder");

/// The project's assets: $ALPENGLOW_ASSETS, else `assets` beside or above the program, else where it was built.
std::filesystem::path assets_folder();
/// Where generated scenes are kept: $ALPENGLOW_CACHE, else $XDG_CACHE_HOME/alpenglow, else ~/.cache/alpenglow.
std::filesystem::path cache_folder();

} // namespace alpenglow
