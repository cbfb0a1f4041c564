#pragma once

#include "image/image.h"

#include <cstdint>

namespace alpenglow {

/// The ground's grain, from grass and gravel down to half a centimetre: pictures that tile without a seam.
struct DetailPictures {
    ByteImage color;  ///< sRGB greys (a trace of hue) whose linear mean is DETAIL_MEAN
    ByteImage normal; ///< tangent space, +X right, +Y up as in glTF
};

/// `size` texels for one DETAIL_PERIOD.
DetailPictures make_detail_pictures(std::uint32_t seed, int size, int threads);

} // namespace alpenglow
