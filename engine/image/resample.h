#pragma once

#include "image/image.h"

namespace alpenglow {

/// The picture at another extent, each pixel the mean of the area that it covers, averaged in linear light. Alpha is
/// averaged as it is. Meant for making pictures smaller; larger ones come out as blocks. Throws Error(bad_input) where
/// either extent has no pixels.
ByteImage resample(ByteImage const& picture, Extent extent);

} // namespace alpenglow
