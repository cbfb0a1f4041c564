// Included by passes that read the G-buffer's depth as `depth_image`.
#ifndef ALPENGLOW_FRAME_PIXEL_DEPTH
#define ALPENGLOW_FRAME_PIXEL_DEPTH

// Reversed, of a pixel that may lie a little outside the picture.
float pixel_depth(ivec2 pixel) { return texelFetch(depth_image, min(pixel, textureSize(depth_image, 0) - 1), 0).r; }

#endif
