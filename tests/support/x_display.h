#pragma once

#include "core/files.h"
#include "image/image.h"
#include "support/background_process.h"

#include <memory>

namespace alpenglow::test {

/// A screen without a monitor: Xvfb on a free display number, its framebuffer a file in `folder`.
class XDisplay {
public:
    explicit XDisplay(std::filesystem::path const& folder) : folder_(folder) {
        std::array<int, 2> ends{};
        if (::pipe2(ends.data(), O_CLOEXEC) != 0) throw std::runtime_error("no pipe");
        server_ = std::make_unique<BackgroundProcess>(
            std::vector<std::string>{"Xvfb", "-displayfd", std::to_string(ends[1]), "-screen", "0", "800x600x24", "-fbdir", folder.string(), "-nocursor", "-nolisten", "tcp"},
            BackgroundProcess::Setup{.output = folder / "xvfb.log", .keep_open = ends[1]});
        ::close(ends[1]);
        std::string number;
        for (char digit = 0; ::read(ends[0], &digit, 1) == 1 && digit != '\n';) number += digit;
        ::close(ends[0]);
        if (!number.empty()) name_ = ":" + number;
    }

    /// As DISPLAY has it; empty where Xvfb did not start.
    std::string const& name() const { return name_; }

    /// The upper left part of the screen as it is now. The file is an X window dump: big-endian header words, the colour
    /// map, then rows of pixels of four bytes: blue, green, red, nothing.
    ByteImage screenshot(Extent extent) const {
        std::vector<std::byte> const dump = read_file(folder_ / "Xvfb_screen0");
        auto const word = [&](std::size_t index) {
            std::size_t value = 0;
            for (std::size_t i = 0; i < 4; ++i) value = value << 8 | std::to_integer<std::size_t>(dump.at(4 * index + i));
            return value;
        };
        constexpr std::size_t HEADER_BYTES = 0, ROW_BYTES = 12, COLORS = 19, COLOR_BYTES = 12;
        std::size_t const pixels = word(HEADER_BYTES) + word(COLORS) * COLOR_BYTES;
        ByteImage image(extent);
        for (std::uint32_t y = 0; y < extent.height; ++y) {
            for (std::uint32_t x = 0; x < extent.width; ++x) {
                std::size_t const at = pixels + y * word(ROW_BYTES) + 4 * std::size_t{x};
                for (std::size_t channel = 0; channel < 3; ++channel) image.at(x, y)[channel] = std::to_integer<std::uint8_t>(dump.at(at + 2 - channel));
                image.at(x, y)[3] = 255;
            }
        }
        return image;
    }

private:
    std::filesystem::path folder_;
    std::unique_ptr<BackgroundProcess> server_;
    std::string name_;
};

} // namespace alpenglow::test
