in vec3 local, world, world_normal, vertex_colour, shadow_place;
in float is_inside;
layout(location = 0, index = 0) out vec4 shown;
layout(location = 0, index = 1) out vec4 passed;  // share of what lies behind that a clear surface lets through

uniform mat4 model;
uniform vec3 eye, outside_colour, inside_colour;
uniform float gloss, roughness, metal, clear, bent, fog_distance, shadow_softness;
uniform sampler2DShadow shadow_map;
uniform sampler2D behind_map;  // the picture without what is clear
uniform vec3 picture_right, picture_up;

#include "noise.glsl"
#include "environment.glsl"
#include "patterns.glsl"

// Share of the sunlight that arrives: the mean of points on a disc, spread evenly.
float sunlight(float slant) {
    if (any(greaterThan(abs(shadow_place - 0.5), vec3(0.5)))) return 1.0;
    const int points = 20;
    float sum = 0.0, bias = mix(0.0035, 0.0008, slant);
    for (int i = 0; i < points; ++i) {
        float radius = shadow_softness * sqrt((float(i) + 0.5) / float(points)), turn = 2.39996 * float(i);
        vec2 offset = radius * vec2(cos(turn), sin(turn));
        sum += texture(shadow_map, vec3(shadow_place.xy + offset, shadow_place.z - bias));
    }
    return sum / float(points);
}

float highlight(vec3 normal, vec3 to_eye, float rough) {
    float sharp = 2.0 / pow(max(rough, 0.06), 2.0);
    return pow(max(dot(normal, normalize(to_eye + to_sun)), 0.0), sharp) * (sharp + 8.0) / 25.0;
}

void main() {
    vec3 base = vertex_colour * mix(outside_colour, inside_colour, is_inside);
    passed = vec4(0.0);
    vec3 to_eye = normalize(eye - world);
    float distance_m = length(eye - world);
    vec3 flat_normal = normalize(cross(dFdx(world), dFdy(world)));
    vec3 normal = dot(world_normal, world_normal) > 1e-12 ? normalize(world_normal) : flat_normal;
    if (!gl_FrontFacing) normal = -normal;
    vec3 rough_normal = normalize(mat3(model) * bumped(transpose(mat3(model)) * normal, local, is_inside, distance_m));
    vec3 smooth_normal = is_inside > 0.5 ? rough_normal : normal;

    float coat = gloss * (1.0 - is_inside) * (1.0 - metal);
    float facing = clamp(dot(smooth_normal, to_eye), 0.0, 1.0);
    float fresnel = mix(0.33 * coat, min(1.0, 5.0 * coat), pow(1.0 - facing, 5.0));
    float slant = max(dot(rough_normal, to_sun), 0.0);
    float sun = slant > 0.0 ? sunlight(max(dot(flat_normal, to_sun), 0.0)) : 0.0;
    vec3 mirror = mirrored(reflect(-to_eye, smooth_normal), roughness);

    if (clear > 0.0) {
        float glass = mix(0.04, 1.0, pow(1.0 - facing, 5.0));
        vec3 tint = pow(base / max(base.r, max(base.g, base.b)), vec3(0.4 / max(facing, 0.25)));
        vec3 frost = is_inside * 0.12 * inside_colour * (ambient(rough_normal) + sun * slant * sun_colour);
        vec3 through = clear * (1.0 - glass) * (1.0 - 0.3 * is_inside) * tint;
        // A share of what is seen through it is bent aside, without other clear things; the rest is all that lies behind.
        float share = gl_FrontFacing ? bent : 0.0;
        vec2 aside = -0.05 * vec2(dot(rough_normal, picture_right), dot(rough_normal, picture_up));
        vec2 place = gl_FragCoord.xy / vec2(textureSize(behind_map, 0)) + aside;
        vec3 behind = share > 0.0 ? texture(behind_map, clamp(place, 0.0, 1.0)).rgb : vec3(0.0);
        vec3 glint = sun * highlight(smooth_normal, to_eye, 0.08) * 0.5 * sun_colour;
        shown = vec4(glass * min(mirror, vec3(1.6)) + glint + frost + 0.02 * base * ambient(normal) + share * through * behind, 1.0);
        passed = vec4((1.0 - share) * through, 1.0);
        return;
    }
    vec3 albedo = patterned(base, local, is_inside);
    vec3 diffuse = albedo * (0.58 * ambient(rough_normal) + 0.42 * sun * slant * sun_colour);
    vec3 glint = sun * highlight(smooth_normal, to_eye, roughness) * sun_colour;
    vec3 metallic = base * (mirror * (0.35 + 0.65 * sun) + glint) + 0.1 * diffuse;
    vec3 light = mix((1.0 - fresnel) * diffuse + fresnel * mirror + coat * 2.0 * glint, metallic, metal);
    if (fog_distance > 0.0) {
        float far = smoothstep(0.15, 1.0, length(eye.xy - world.xy) / fog_distance);
        light = mix(light, background(normalize(world - eye) * vec3(1, 1, 0)), far);
    }
    shown = vec4(light, 1.0);
}
