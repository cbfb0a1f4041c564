#pragma once

#include "core/error.h"

#include <cstddef>
#include <cstdint>
#include <cstring>
#include <span>
#include <utility>
#include <vector>

#include <OpenEXR/ImfIO.h>

namespace alpenglow {

constexpr char const* WHOLE_EXR_NEEDED = "give a whole EXR file";

/// OpenEXR's output, kept in memory.
class MemoryWriter : public Imf::OStream {
public:
    MemoryWriter() : OStream("memory") {}

    void write(char const* data, int size) override {
        std::size_t const end = position_ + static_cast<std::size_t>(size);
        if (end > bytes_.size()) bytes_.resize(end);
        std::memcpy(bytes_.data() + position_, data, static_cast<std::size_t>(size));
        position_ = end;
    }
    std::uint64_t tellp() override { return position_; }
    void seekp(std::uint64_t position) override { position_ = position; }

    std::vector<std::byte> take() { return std::move(bytes_); }

private:
    std::vector<std::byte> bytes_;
    std::size_t position_ = 0;
};

/// OpenEXR's input from memory. Throws Error(bad_input) where it asks for more than there is.
class MemoryReader : public Imf::IStream {
public:
    explicit MemoryReader(std::span<std::byte const> bytes) : IStream("memory"), bytes_(bytes) {}

    bool read(char* data, int size) override {
        auto const wanted = static_cast<std::size_t>(size);
        if (position_ > bytes_.size() || wanted > bytes_.size() - position_) {
            throw Error(ErrorKind::bad_input, "EXR file is cut short", {}, WHOLE_EXR_NEEDED);
        }
        std::memcpy(data, bytes_.data() + position_, wanted);
        position_ += wanted;
        return position_ < bytes_.size();
    }
    std::uint64_t tellg() override { return position_; }
    void seekg(std::uint64_t position) override { position_ = position; }

private:
    std::span<std::byte const> bytes_;
    std::uint64_t position_ = 0;
};

} // namespace alpenglow
