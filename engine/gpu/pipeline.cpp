#include "gpu/pipeline.h"

#include <array>
#include <fmt/format.h>

namespace alpenglow {

namespace {

VkDescriptorSetLayout make_push_layout(Device const& device, std::vector<SlotLayout> const& slots,
                                       VkShaderStageFlags stages) {
    std::vector<VkDescriptorSetLayoutBinding> bindings;
    for (SlotLayout const& slot : slots) bindings.push_back({slot.slot, slot.type, 1, stages, nullptr});
    VkDescriptorSetLayoutCreateInfo info{};
    info.sType = VK_STRUCTURE_TYPE_DESCRIPTOR_SET_LAYOUT_CREATE_INFO;
    info.flags = VK_DESCRIPTOR_SET_LAYOUT_CREATE_PUSH_DESCRIPTOR_BIT_KHR;
    info.bindingCount = static_cast<std::uint32_t>(bindings.size());
    info.pBindings = bindings.data();
    VkDescriptorSetLayout layout = VK_NULL_HANDLE;
    check(vkCreateDescriptorSetLayout(device.handle(), &info, nullptr, &layout), "making a descriptor layout");
    return layout;
}

VkPipelineLayout make_layout(Device const& device, std::span<VkDescriptorSetLayout const> sets,
                             VkShaderStageFlags stages) {
    VkPushConstantRange const push{stages, 0, PUSH_CONSTANT_BYTES};
    VkPipelineLayoutCreateInfo info{};
    info.sType = VK_STRUCTURE_TYPE_PIPELINE_LAYOUT_CREATE_INFO;
    info.setLayoutCount = static_cast<std::uint32_t>(sets.size());
    info.pSetLayouts = sets.data();
    info.pushConstantRangeCount = 1;
    info.pPushConstantRanges = &push;
    VkPipelineLayout layout = VK_NULL_HANDLE;
    check(vkCreatePipelineLayout(device.handle(), &info, nullptr, &layout), "making a pipeline layout");
    return layout;
}

/// A shader module that lives as long as the pipeline is being made.
class Module {
public:
    Module(Device const& device, ShaderCode const& code) : device_(device) {
        VkShaderModuleCreateInfo info{};
        info.sType = VK_STRUCTURE_TYPE_SHADER_MODULE_CREATE_INFO;
        info.codeSize = code.words.size_bytes();
        info.pCode = code.words.data();
        check(vkCreateShaderModule(device.handle(), &info, nullptr, &module_),
              std::string("loading the shader ") + code.name);
    }
    ~Module() { vkDestroyShaderModule(device_.handle(), module_, nullptr); }
    Module(Module const&) = delete;
    Module& operator=(Module const&) = delete;

    VkPipelineShaderStageCreateInfo stage(VkShaderStageFlagBits bit) const {
        VkPipelineShaderStageCreateInfo info{};
        info.sType = VK_STRUCTURE_TYPE_PIPELINE_SHADER_STAGE_CREATE_INFO;
        info.stage = bit;
        info.module = module_;
        info.pName = "main";
        return info;
    }

private:
    Device const& device_;
    VkShaderModule module_ = VK_NULL_HANDLE;
};

VkPipeline make_compute(Device const& device, ComputeState const& state, VkPipelineLayout layout) {
    Module const module(device, state.shader);
    std::vector<VkSpecializationMapEntry> entries;
    for (std::uint32_t id = 0; id < state.specialization.size(); ++id)
        entries.push_back({id, id * std::uint32_t(sizeof(std::int32_t)), sizeof(std::int32_t)});
    VkSpecializationInfo const constants{static_cast<std::uint32_t>(entries.size()), entries.data(),
                                         std::span(state.specialization).size_bytes(), state.specialization.data()};
    VkComputePipelineCreateInfo info{};
    info.sType = VK_STRUCTURE_TYPE_COMPUTE_PIPELINE_CREATE_INFO;
    info.stage = module.stage(VK_SHADER_STAGE_COMPUTE_BIT);
    info.stage.pSpecializationInfo = &constants;
    info.layout = layout;
    VkPipeline pipeline = VK_NULL_HANDLE;
    check(vkCreateComputePipelines(device.handle(), VK_NULL_HANDLE, 1, &info, nullptr, &pipeline),
          std::string("making the pipeline ") + state.shader.name);
    return pipeline;
}

VkPipeline make_raster(Device const& device, RasterState const& state, VkPipelineLayout layout) {
    std::vector<VkPipelineShaderStageCreateInfo> stages;
    Module const vertex(device, state.vertex);
    stages.push_back(vertex.stage(VK_SHADER_STAGE_VERTEX_BIT));
    std::unique_ptr<Module> fragment;
    if (!state.fragment.words.empty()) {
        fragment = std::make_unique<Module>(device, state.fragment);
        stages.push_back(fragment->stage(VK_SHADER_STAGE_FRAGMENT_BIT));
    }

    VkVertexInputBindingDescription const binding{0, state.vertices.stride, VK_VERTEX_INPUT_RATE_VERTEX};
    VkPipelineVertexInputStateCreateInfo input{};
    input.sType = VK_STRUCTURE_TYPE_PIPELINE_VERTEX_INPUT_STATE_CREATE_INFO;
    input.vertexBindingDescriptionCount = state.vertices.stride > 0 ? 1 : 0;
    input.pVertexBindingDescriptions = &binding;
    input.vertexAttributeDescriptionCount = static_cast<std::uint32_t>(state.vertices.attributes.size());
    input.pVertexAttributeDescriptions = state.vertices.attributes.data();

    VkPipelineInputAssemblyStateCreateInfo assembly{};
    assembly.sType = VK_STRUCTURE_TYPE_PIPELINE_INPUT_ASSEMBLY_STATE_CREATE_INFO;
    assembly.topology = VK_PRIMITIVE_TOPOLOGY_TRIANGLE_LIST;
    VkPipelineViewportStateCreateInfo viewport{};
    viewport.sType = VK_STRUCTURE_TYPE_PIPELINE_VIEWPORT_STATE_CREATE_INFO;
    viewport.viewportCount = viewport.scissorCount = 1;

    VkPipelineRasterizationStateCreateInfo raster{};
    raster.sType = VK_STRUCTURE_TYPE_PIPELINE_RASTERIZATION_STATE_CREATE_INFO;
    raster.depthClampEnable = state.shadow;
    raster.depthBiasEnable = state.shadow;
    raster.depthBiasSlopeFactor = state.slope_bias;
    raster.lineWidth = 1;
    VkPipelineMultisampleStateCreateInfo multisample{};
    multisample.sType = VK_STRUCTURE_TYPE_PIPELINE_MULTISAMPLE_STATE_CREATE_INFO;
    multisample.rasterizationSamples = VK_SAMPLE_COUNT_1_BIT;
    VkPipelineDepthStencilStateCreateInfo depth{};
    depth.sType = VK_STRUCTURE_TYPE_PIPELINE_DEPTH_STENCIL_STATE_CREATE_INFO;
    depth.depthTestEnable = depth.depthWriteEnable = state.depth != VK_FORMAT_UNDEFINED;
    depth.depthCompareOp = state.shadow ? VK_COMPARE_OP_LESS : VK_COMPARE_OP_GREATER;

    VkPipelineColorBlendAttachmentState target{};
    target.colorWriteMask =
        VK_COLOR_COMPONENT_R_BIT | VK_COLOR_COMPONENT_G_BIT | VK_COLOR_COMPONENT_B_BIT | VK_COLOR_COMPONENT_A_BIT;
    target.blendEnable = state.blend;
    target.srcColorBlendFactor = VK_BLEND_FACTOR_SRC_ALPHA;
    target.dstColorBlendFactor = VK_BLEND_FACTOR_ONE_MINUS_SRC_ALPHA;
    target.srcAlphaBlendFactor = VK_BLEND_FACTOR_ONE;
    target.dstAlphaBlendFactor = VK_BLEND_FACTOR_ONE_MINUS_SRC_ALPHA;
    std::vector<VkPipelineColorBlendAttachmentState> const attachments(state.colors.size(), target);
    VkPipelineColorBlendStateCreateInfo blend{};
    blend.sType = VK_STRUCTURE_TYPE_PIPELINE_COLOR_BLEND_STATE_CREATE_INFO;
    blend.attachmentCount = static_cast<std::uint32_t>(attachments.size());
    blend.pAttachments = attachments.data();

    std::array const dynamic = {VK_DYNAMIC_STATE_VIEWPORT, VK_DYNAMIC_STATE_SCISSOR, VK_DYNAMIC_STATE_CULL_MODE,
                                VK_DYNAMIC_STATE_FRONT_FACE};
    VkPipelineDynamicStateCreateInfo dynamics{};
    dynamics.sType = VK_STRUCTURE_TYPE_PIPELINE_DYNAMIC_STATE_CREATE_INFO;
    dynamics.dynamicStateCount = static_cast<std::uint32_t>(dynamic.size());
    dynamics.pDynamicStates = dynamic.data();
    VkPipelineRenderingCreateInfo rendering{};
    rendering.sType = VK_STRUCTURE_TYPE_PIPELINE_RENDERING_CREATE_INFO;
    rendering.colorAttachmentCount = static_cast<std::uint32_t>(state.colors.size());
    rendering.pColorAttachmentFormats = state.colors.data();
    rendering.depthAttachmentFormat = state.depth;

    VkGraphicsPipelineCreateInfo info{};
    info.sType = VK_STRUCTURE_TYPE_GRAPHICS_PIPELINE_CREATE_INFO;
    info.pNext = &rendering;
    info.stageCount = static_cast<std::uint32_t>(stages.size());
    info.pStages = stages.data();
    info.pVertexInputState = &input;
    info.pInputAssemblyState = &assembly;
    info.pViewportState = &viewport;
    info.pRasterizationState = &raster;
    info.pMultisampleState = &multisample;
    info.pDepthStencilState = &depth;
    info.pColorBlendState = &blend;
    info.pDynamicState = &dynamics;
    info.layout = layout;
    VkPipeline pipeline = VK_NULL_HANDLE;
    check(vkCreateGraphicsPipelines(device.handle(), VK_NULL_HANDLE, 1, &info, nullptr, &pipeline),
          std::string("making a pipeline of ") + state.vertex.name);
    return pipeline;
}

std::unique_ptr<Pipeline> make(Device const& device, RasterState const& state, std::vector<SlotLayout> const& slots) {
    constexpr VkShaderStageFlags stages = VK_SHADER_STAGE_VERTEX_BIT | VK_SHADER_STAGE_FRAGMENT_BIT;
    VkDescriptorSetLayout const set0 = make_push_layout(device, slots, stages);
    std::vector<VkDescriptorSetLayout> sets = {set0};
    if (state.set1) sets.push_back(state.set1);
    VkPipelineLayout const layout = make_layout(device, sets, stages);
    return std::make_unique<Pipeline>(device, set0, layout, make_raster(device, state, layout));
}

std::unique_ptr<Pipeline> make(Device const& device, ComputeState const& state, std::vector<SlotLayout> const& slots) {
    VkDescriptorSetLayout const set0 = make_push_layout(device, slots, VK_SHADER_STAGE_COMPUTE_BIT);
    VkPipelineLayout const layout = make_layout(device, std::array{set0}, VK_SHADER_STAGE_COMPUTE_BIT);
    return std::make_unique<Pipeline>(device, set0, layout, make_compute(device, state, layout));
}

std::string key_of(ComputeState const& state) {
    return fmt::format("{} {}", state.shader.name, fmt::join(state.specialization, " "));
}

std::string key_of(RasterState const& state) {
    char const* const fragment = state.fragment.name ? state.fragment.name : "";
    std::string key =
        fmt::format("{}+{} {} {} {}", state.vertex.name, fragment, state.shadow, state.slope_bias, state.blend);
    for (VkFormat color : state.colors) key += fmt::format(" {}", static_cast<int>(color));
    return key;
}

} // namespace

Pipeline::~Pipeline() {
    vkDestroyPipeline(device_.handle(), pipeline_, nullptr);
    vkDestroyPipelineLayout(device_.handle(), layout_, nullptr);
    vkDestroyDescriptorSetLayout(device_.handle(), set0_, nullptr);
}

std::string PipelineRecipe::key() const {
    std::string key = std::visit([](auto const& kind) { return key_of(kind); }, state);
    for (SlotLayout const& slot : slots) key += fmt::format(" {}:{}", slot.slot, static_cast<int>(slot.type));
    return key;
}

std::unique_ptr<Pipeline> make_pipeline(Device const& device, PipelineRecipe const& recipe) {
    return std::visit([&](auto const& state) { return make(device, state, recipe.slots); }, recipe.state);
}

} // namespace alpenglow
