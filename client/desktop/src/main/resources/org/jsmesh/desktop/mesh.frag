#version 330 core
// Hemisphere light from above, a key light and a fill light that stay with the eye, a slight highlight; the formula is that of Lighting.
in vec3 eyePosition;
in vec3 eyeNormal;
in vec2 imagePosition;
in vec3 linearColour;

uniform mat4 view;
uniform vec4 surface;
uniform bool textured;
uniform sampler2D image;
uniform vec3 sky;
uniform vec3 ground;
uniform vec3 keyDirection;
uniform vec3 keyLight;
uniform vec3 fillDirection;
uniform vec3 fillLight;
uniform float highlight;
uniform float shininess;

out vec4 colour;

vec3 toScreen(vec3 l) {
    vec3 c = clamp(l, 0, 1);
    return mix(12.92 * c, 1.055 * pow(c, vec3(1 / 2.4)) - .055, greaterThan(c, vec3(.0031308)));
}

void main() {
    vec3 toEye = normalize(-eyePosition);
    vec3 n = dot(eyeNormal, eyeNormal) > 0 ? normalize(eyeNormal) : toEye;
    // Both sides of a surface are lit: scanned and modelled meshes have holes, and some have faces turned over.
    if (!gl_FrontFacing) n = -n;
    vec3 up = view[1].xyz;
    vec3 light = mix(ground, sky, .5 + .5 * dot(n, up))
            + keyLight * max(dot(n, keyDirection), 0)
            + fillLight * max(dot(n, fillDirection), 0);
    float shine = highlight * pow(max(dot(n, normalize(keyDirection + toEye)), 0), shininess);
    vec3 albedo = surface.rgb * linearColour;
    if (textured) albedo *= texture(image, imagePosition).rgb;
    // Premultiplied, so that a picture without background keeps its edges.
    colour = vec4(toScreen(albedo * light + shine * keyLight) * surface.a, surface.a);
}
