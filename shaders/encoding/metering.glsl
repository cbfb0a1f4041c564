// From a histogram of log2 luminance to an exposure, and the eye's way there. Luminance relative to the sun's irradiance.
#ifndef ALPENGLOW_ENCODING_METERING
#define ALPENGLOW_ENCODING_METERING
#include "interop/exposure.h"
SHADER_NAMESPACE_BEGIN

// Tuned against the exposures that were chosen by hand for the views of assets/views.
CONSTANT float METERED_FROM = 0.40f;     // shares of the pixels that are not black between which luminance is averaged:
CONSTANT float METERED_TO = 0.95f;       //   what is darker is shade or night, what is brighter the sun's surroundings
CONSTANT float HIGHLIGHT_SHARE = 0.99f;  // what is brighter than that may burn out
CONSTANT float HIGHLIGHT_HEADROOM = 3.5f; // [stops] that highlights may be above the mean
CONSTANT float SHOWN_MEAN = -2.4f;       // [stops] below 1 of the mean, behind exposure: 0.19
CONSTANT float DIM_BELOW = -7.0f;        // [stops] below which pictures grow darker: dusk is to look like dusk
CONSTANT float DIM_SLOPE = 0.15f;        // stops for each stop

// The bin of a luminance; 0 where it is black.
INLINE int histogram_bin(float luminance) {
    float place = (log2(max(luminance, 1e-30f)) - HISTOGRAM_LOWEST) / HISTOGRAM_STEP;
    return int(clamp(place + 1.0f, 0.0f, float(HISTOGRAM_BINS - 1)));
}

// log2 of the luminance in the middle of a bin. Needs bin >= 1.
INLINE float stops_of_bin(int bin) { return HISTOGRAM_LOWEST + (float(bin) - 0.5f) * HISTOGRAM_STEP; }

// A sum over the histogram, bin by bin from 1 on.
struct Metering {
    float pixels; // that are not black
    float below;  // of them in the bins before
    float sum;    // of stops, over the metered share
    float highlight; // [stops] that HIGHLIGHT_SHARE of the pixels stay below
};

INLINE Metering begin_metering(float pixels) { return Metering(pixels, 0.0f, 0.0f, HISTOGRAM_LOWEST); }

INLINE void meter_bin(INOUT(Metering) metering, int bin, float count) {
    float above = metering.below + count;
    float from = METERED_FROM * metering.pixels, to = METERED_TO * metering.pixels;
    metering.sum += (clamp(above, from, to) - clamp(metering.below, from, to)) * stops_of_bin(bin);
    float highlight = HIGHLIGHT_SHARE * metering.pixels;
    if (metering.below < highlight && above >= highlight) metering.highlight = stops_of_bin(bin);
    metering.below = above;
}

// log2 of the luminance to expose for: the mean of the metered share, or what keeps highlights from burning out. Of a
// black picture the darkest there is.
INLINE float metered_stops(Metering metering) {
    float share = (METERED_TO - METERED_FROM) * metering.pixels;
    float mean = metering.sum / max(share, 1e-6f);
    return metering.pixels > 0.0f ? max(mean, metering.highlight - HIGHLIGHT_HEADROOM) : HISTOGRAM_LOWEST;
}

// The exposure [stops] of a picture so metered.
INLINE float exposure_for(float metered, ExposurePush push) {
    float dim = DIM_SLOPE * max(DIM_BELOW - metered, 0.0f);
    return clamp(SHOWN_MEAN - metered - dim + push.compensation, push.least, push.most);
}

// Where the exposure [stops] has come on its way to `target`: at most the given speed, and slower over the last stop.
INLINE float adapted_exposure(float before, float target, ExposurePush push) {
    float way = abs(target - before);
    float reach = push.seconds * (target < before ? push.light_speed : push.dark_speed);
    float moved = min(reach, way * (1.0f - exp(-reach)));
    return push.seconds < 0.0f ? target : before + (target < before ? -moved : moved);
}

SHADER_NAMESPACE_END
#endif
