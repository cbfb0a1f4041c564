#version 460
#extension GL_GOOGLE_include_directive : require
#extension GL_EXT_scalar_block_layout : require
#include "interop/frame_block.glsl"
#include "models/tables/aerial_perspective.glsl"
#include "models/tables/isotropic.glsl"

layout(local_size_x = WORKGROUP_SIZE, local_size_y = WORKGROUP_SIZE) in;
layout(set = 0, binding = TABLE_SUNLIGHT_SLOT) uniform sampler2D sunlight_table;
layout(set = 0, binding = TABLE_ISOTROPIC_SLOT) uniform sampler2D isotropic_table;
layout(set = 0, binding = TABLE_RESULT_SLOT, rgba32f) uniform writeonly image2D table;

const int SLICE_CELLS = 2;

void main() {
    ivec2 column = ivec2(gl_GlobalInvocationID.xy);
    vec2 ndc = 2.0f * vec2(column) / float(AERIAL_SIZE - 1) - 1.0f;
    vec3 direction = normalize(frame.ray_centre + ndc.x * frame.ray_right + ndc.y * frame.ray_up);
    float radius = frame.atmosphere.ground_radius;
    AirRay ray = make_air_ray(radius, frame.camera_altitude, dot(direction, frame.camera_up),
                              dot(frame.camera_up, frame.to_sun), dot(direction, frame.to_sun));
    RayPhases phases = phases_of(frame.atmosphere, ray.nu);
    float reach = aerial_reach(radius, frame.camera_altitude);
    AirLight light = no_air_light();
    float from = 0.0f;
    for (int slice = 0; slice < AERIAL_SLICES; ++slice) {
        float cell = (aerial_distance(reach, slice) - from) / float(SLICE_CELLS);
        for (int i = 0; i < SLICE_CELLS; ++i) {
            add_isotropic_cell(light, frame.atmosphere, sunlight_table, isotropic_table, phases, ray,
                               from + (float(i) + 0.5f) * cell, cell);
        }
        from = aerial_distance(reach, slice);
        ivec2 texel = ivec2(slice * AERIAL_SIZE + column.x, column.y);
        imageStore(table, texel, vec4(light.inscattered, 1.0f));
        imageStore(table, texel + ivec2(0, AERIAL_SIZE), vec4(light.transmittance, 1.0f));
    }
}
