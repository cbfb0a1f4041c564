#include "render/plan.h"

namespace alpenglow {

bool reads(ImageUse use) {
    return use == ImageUse::sample || use == ImageUse::storage_update || use == ImageUse::color_update ||
           use == ImageUse::depth_update || use == ImageUse::present;
}

bool writes(ImageUse use) { return use != ImageUse::sample && use != ImageUse::present; }

ImageState state_of(ImageUse use) {
    constexpr VkPipelineStageFlags2 compute = VK_PIPELINE_STAGE_2_COMPUTE_SHADER_BIT;
    constexpr VkPipelineStageFlags2 depth =
        VK_PIPELINE_STAGE_2_EARLY_FRAGMENT_TESTS_BIT | VK_PIPELINE_STAGE_2_LATE_FRAGMENT_TESTS_BIT;
    constexpr VkPipelineStageFlags2 color = VK_PIPELINE_STAGE_2_COLOR_ATTACHMENT_OUTPUT_BIT;
    switch (use) {
    case ImageUse::sample:
        return {VK_IMAGE_LAYOUT_SHADER_READ_ONLY_OPTIMAL, compute | VK_PIPELINE_STAGE_2_FRAGMENT_SHADER_BIT,
                VK_ACCESS_2_SHADER_SAMPLED_READ_BIT};
    case ImageUse::storage_write:
        return {VK_IMAGE_LAYOUT_GENERAL, compute, VK_ACCESS_2_SHADER_STORAGE_WRITE_BIT};
    case ImageUse::storage_clear:
        return {VK_IMAGE_LAYOUT_GENERAL, compute | VK_PIPELINE_STAGE_2_CLEAR_BIT,
                VK_ACCESS_2_SHADER_STORAGE_WRITE_BIT | VK_ACCESS_2_TRANSFER_WRITE_BIT};
    case ImageUse::storage_update:
        return {VK_IMAGE_LAYOUT_GENERAL, compute,
                VK_ACCESS_2_SHADER_STORAGE_READ_BIT | VK_ACCESS_2_SHADER_STORAGE_WRITE_BIT};
    case ImageUse::color_clear:
        return {VK_IMAGE_LAYOUT_COLOR_ATTACHMENT_OPTIMAL, color, VK_ACCESS_2_COLOR_ATTACHMENT_WRITE_BIT};
    case ImageUse::color_update:
        return {VK_IMAGE_LAYOUT_COLOR_ATTACHMENT_OPTIMAL, color,
                VK_ACCESS_2_COLOR_ATTACHMENT_READ_BIT | VK_ACCESS_2_COLOR_ATTACHMENT_WRITE_BIT};
    case ImageUse::depth_clear:
    case ImageUse::depth_update:
        return {VK_IMAGE_LAYOUT_DEPTH_ATTACHMENT_OPTIMAL, depth,
                VK_ACCESS_2_DEPTH_STENCIL_ATTACHMENT_READ_BIT | VK_ACCESS_2_DEPTH_STENCIL_ATTACHMENT_WRITE_BIT};
    case ImageUse::present:
        return {VK_IMAGE_LAYOUT_PRESENT_SRC_KHR, VK_PIPELINE_STAGE_2_NONE, VK_ACCESS_2_NONE};
    }
    return {};
}

namespace {

struct Tracked {
    ImageState state;
    bool has_content = false;
    bool written = false; ///< the last access wrote
};

bool only_clears(ImageUse use) {
    return use == ImageUse::storage_write || use == ImageUse::storage_clear || use == ImageUse::color_clear ||
           use == ImageUse::depth_clear;
}

void refuse_repeats(PlannedPass const& pass, std::span<PlannedImage const> images) {
    for (std::size_t i = 0; i < pass.accesses.size(); ++i) {
        std::uint32_t const image = pass.accesses[i].image.index;
        if (image >= images.size()) throw GraphError("pass " + pass.name + " uses an image that nobody declared");
        for (std::size_t j = 0; j < i; ++j) {
            bool const both_sample = pass.accesses[i].use == ImageUse::sample && pass.accesses[j].use == ImageUse::sample;
            if (pass.accesses[j].image.index == image && !both_sample)
                throw GraphError("pass " + pass.name + " uses " + images[image].name + " twice");
        }
    }
}

} // namespace

Plan plan(std::span<PlannedImage const> images, std::span<PlannedPass const> passes) {
    std::vector<Tracked> tracked;
    for (PlannedImage const& image : images) tracked.push_back({image.before, image.has_content, true});

    Plan result;
    for (PlannedPass const& pass : passes) {
        refuse_repeats(pass, images);
        std::vector<PlannedBarrier>& barriers = result.barriers.emplace_back();
        for (ImageAccess const& access : pass.accesses) {
            Tracked& image = tracked[access.image.index];
            if (reads(access.use) && !image.has_content) {
                throw GraphError("pass " + pass.name + " reads " + images[access.image.index].name +
                                 ", which nobody made");
            }
            ImageState const next = state_of(access.use);
            bool const reads_again = !writes(access.use) && !image.written && image.state.layout == next.layout;
            if (!reads_again) {
                ImageState before = image.state;
                // What is cleared in its first use of the frame needs no old content, only to wait for whoever used it
                // last.
                if (only_clears(access.use) && !image.has_content) before.layout = VK_IMAGE_LAYOUT_UNDEFINED;
                barriers.push_back({access.image, before, next});
            }
            image = {next, true, writes(access.use)};
        }
    }
    for (Tracked const& image : tracked) result.after.push_back(image.state);
    return result;
}

} // namespace alpenglow
