#include "interop/models/march.h"

#include "atmosphere/optical_depth.glsl"
#include "interop/ground_light.h"
#include "interop/multiple_scattering.h"
#include "render/models/model.h"
#include "render/passes/sunlight.h"
#include "render/passes/transmittance.h"

#include <embedded_shaders.h>

#include <algorithm>

namespace alpenglow {

namespace {

enum Tables : std::size_t {
    TRANSMITTANCE,
    SUNLIGHT,
    RESPONSE_ORDERS,
    RESPONSE,
    COARSE_FIRST_ORDER,
    COARSE_ORDERS,
    FIRST_ORDER,
    ORDERS
};

constexpr Extent NODES{MULTIPLE_SCATTERING_WIDTH, MULTIPLE_SCATTERING_HEIGHT};
constexpr Extent COARSE_NODES{NODES.width / 2, NODES.height / 2};
constexpr Extent RESPONSE_NODES{1, NODES.height};

/// Orders of scattering behind the first that are added on a quarter of the nodes, and as many on all; and how often the orders
/// to come are added as a geometric series. An order is worth 0.4 of the last on Earth, whose table is within 0.01 % of the
/// limit then; 0.85 on the dense planet, where coarse nodes are off by up to a sixth.
constexpr int ROUNDS = 6, ROUNDS_IN_THICK_AIR = 12, EXTRAPOLATION = 6;
/// Optical depth up to the zenith.
constexpr float THICK_AIR = 1;
/// And of the light of bright ground, the last without what is to come.
constexpr int RESPONSE_ROUNDS = 19;

constexpr Extent moments_size(Extent nodes) { return {nodes.width, LIGHT_TILES * nodes.height}; }

AirTableStep first_order_step(std::string const& pass, Tables table, Extent nodes) {
    return {.pass = pass,
            .shader = shaders::first_order_comp,
            .groups = static_cast<std::uint32_t>(nodes.pixels()),
            .reads = {{SUNLIGHT, FIRST_ORDER_SUNLIGHT_SLOT}},
            .makes = {table, FIRST_ORDER_TABLE_SLOT}};
}

/// One order more than in `before`. Where it extrapolates, `orders` held one order less two steps ago.
AirTableStep order_step(std::string const& pass, Tables first_order, Tables before, Tables orders, Extent nodes,
                        bool extrapolates) {
    return {.pass = pass,
            .shader = shaders::multiple_scattering_comp,
            .groups = static_cast<std::uint32_t>(nodes.pixels()),
            .reads = {{first_order, MULTIPLE_SCATTERING_FIRST_ORDER_SLOT, NEAREST_CLAMP},
                      {before, MULTIPLE_SCATTERING_BEFORE_SLOT}},
            .makes = {orders, MULTIPLE_SCATTERING_TABLE_SLOT},
            .mode = extrapolates ? MULTIPLE_SCATTERING_EXTRAPOLATES : 0,
            .updates = extrapolates};
}

/// The light of the ground itself first; with the last round the table is whole.
AirTableStep response_step(int round) {
    int const mode = round == 0 ? GROUND_RESPONSE_STARTS : round % EXTRAPOLATION == 0 ? MULTIPLE_SCATTERING_EXTRAPOLATES : 0;
    return {.pass = "ground_response",
            .shader = shaders::ground_response_comp,
            .groups = static_cast<std::uint32_t>(RESPONSE_NODES.pixels()),
            .reads = {{round == 0 ? SUNLIGHT : RESPONSE_ORDERS, GROUND_RESPONSE_BEFORE_SLOT}},
            .makes = {round == RESPONSE_ROUNDS ? RESPONSE : RESPONSE_ORDERS, GROUND_RESPONSE_TABLE_SLOT},
            .mode = mode,
            .updates = mode == MULTIPLE_SCATTERING_EXTRAPOLATES};
}

/// All orders on a quarter of the nodes first: what they are off by is smooth, and little is left to do for the rest.
std::vector<AirTableStep> make_steps(int rounds) {
    std::vector<AirTableStep> steps{transmittance_step(TRANSMITTANCE), sunlight_step(SUNLIGHT, TRANSMITTANCE),
                                    first_order_step("coarse_first_order", COARSE_FIRST_ORDER, COARSE_NODES)};
    for (int round = 1; round <= rounds; ++round)
        steps.push_back(order_step("coarse_orders", COARSE_FIRST_ORDER, round == 1 ? COARSE_FIRST_ORDER : COARSE_ORDERS,
                                   COARSE_ORDERS, COARSE_NODES, round % EXTRAPOLATION == 0));
    for (int round = 0; round <= RESPONSE_ROUNDS; ++round) steps.push_back(response_step(round));
    steps.push_back(first_order_step("first_order", FIRST_ORDER, NODES));
    for (int round = 1; round <= rounds; ++round)
        steps.push_back(order_step("multiple_scattering", FIRST_ORDER, round == 1 ? COARSE_ORDERS : ORDERS, ORDERS,
                                   NODES, round % EXTRAPOLATION == 0));
    return steps;
}

std::vector<AirTableStep> const& steps(shader::Atmosphere const& air) {
    static std::vector<AirTableStep> const STEPS = make_steps(ROUNDS), IN_THICK_AIR = make_steps(ROUNDS_IN_THICK_AIR);
    glm::vec3 const depth = shader::compute_optical_depth_to_top(air, 0, 1);
    return std::max({depth.r, depth.g, depth.b}) > THICK_AIR ? IN_THICK_AIR : STEPS;
}

/// The table of all orders over that ground: of this frame, made from the planet's, whose own it is where that is the
/// planet's ground.
ImageId orders_over(FrameGraph& graph, AirTableInputs const& inputs, GroundAround const& ground, char const* name) {
    if (ground == planet_ground(inputs.in.world.planet)) return inputs.tables[ORDERS];
    ImageShape const shape{VK_FORMAT_R32G32B32A32_SFLOAT, moments_size(NODES)};
    ImageId const orders = graph.add_image(name, shape, ShowScale::logarithm);
    graph.add(ComputePass{"ground_light",
                          shaders::ground_light_comp,
                          {constants(FRAME_SLOT, inputs.frame),
                           sampled(GROUND_LIGHT_SUNLIGHT_SLOT, inputs.tables[SUNLIGHT]),
                           sampled(GROUND_LIGHT_ORDERS_SLOT, inputs.tables[ORDERS]),
                           sampled(GROUND_LIGHT_RESPONSE_SLOT, inputs.tables[RESPONSE]),
                           stored(GROUND_LIGHT_TABLE_SLOT, orders)},
                          NODES,
                          bytes_of(shader::GroundLightPush{ground.albedo, ground.altitude})});
    return orders;
}

std::vector<Slot> model_slots(FrameGraph& graph, AirTableInputs const& inputs) {
    return {sampled(MARCH_SUNLIGHT_SLOT, inputs.tables[SUNLIGHT]),
            sampled(MARCH_MULTIPLE_SCATTERING_SLOT,
                    orders_over(graph, inputs, inputs.in.ground, "light_over_ground")),
            sampled(MARCH_TRANSMITTANCE_SLOT, inputs.tables[TRANSMITTANCE])};
}

SkyTables sky_tables(FrameGraph& graph, AirTableInputs const& inputs, GroundAround const& ground) {
    return {inputs.tables[SUNLIGHT], orders_over(graph, inputs, ground, "light_over_terrain")};
}

int air_variant(FrameInputs const& in) {
    int const orders = in.settings.multiple_scattering ? 0 : MARCH_ONE_ORDER;
    if ((in.constants.front().flags & FRAME_SHAFTS) == 0) return orders | MARCH_NO_SHAFTS;
    return orders | (in.settings.shafts == "exact" ? MARCH_EXACT : 0) | (in.settings.soft_shafts ? MARCH_SOFT_SUN : 0);
}

int air_stride(Settings const& settings) {
    if (settings.air_stride != "auto") return settings.air_stride == "1" ? 1 : settings.air_stride == "2" ? 2 : 4;
    return settings.shafts == "exact" ? 1 : 4;
}

} // namespace

AirModel make_march() {
    return {.name = "march",
            .help = "each pixel's ray marched; the sun's way and all further orders from tables",
            .air = shaders::air_march_comp,
            .air_repair = shaders::air_repair_march_comp,
            .lighting = shaders::lighting_march_comp,
            .tables = {{"transmittance", {TRANSMITTANCE_WIDTH, TRANSMITTANCE_HEIGHT}, ShowScale::optical_depth},
                       {"sunlight", {TRANSMITTANCE_WIDTH, TRANSMITTANCE_HEIGHT}, ShowScale::optical_depth},
                       {"ground_response_orders", moments_size(RESPONSE_NODES), ShowScale::logarithm},
                       {"ground_response", moments_size(RESPONSE_NODES), ShowScale::logarithm},
                       {"coarse_first_order", moments_size(COARSE_NODES), ShowScale::logarithm},
                       {"coarse_orders", moments_size(COARSE_NODES), ShowScale::logarithm},
                       {"first_order", moments_size(NODES), ShowScale::logarithm},
                       {"multiple_scattering", moments_size(NODES), ShowScale::logarithm}},
            .steps = steps,
            .slots = model_slots,
            .sky = sky_tables,
            .air_variant = air_variant,
            .air_stride = air_stride,
            .finds_shafts = true,
            .limits = [](World const&, Settings const&, bool) -> std::string_view { return {}; }};
}

} // namespace alpenglow
