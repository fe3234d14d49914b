#version 330 core
// Filmic tone curve of Hejl and Burgess-Dawson (2010). The rational fit includes the display's gamma, so that
// no pixel needs a power function.
vec3 tone_mapped(vec3 light) {
    vec3 x = max(light - 0.004, 0.0);
    return (x * (6.2 * x + 0.5)) / (x * (6.2 * x + 1.7) + 0.06);
}
