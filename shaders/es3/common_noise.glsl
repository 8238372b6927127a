// Of the picture, of which the framebuffer may have a part.
vec2 pixel() { return gl_FragCoord.xy + vec2(0.0, bottomRow); }
// Chance per pixel, 0..1: interleaved gradient noise (Jimenez 2014). Fragment shaders only. `chance` goes evenly through 0..1 from sample
// to sample, for every pixel and each of the four by itself.
float pixelNoise() { return fract(fract(52.9829189 * fract(dot(pixel(), vec2(0.06711056, 0.00583715)))) + chance.x); }
// The same for each 2 by 2 pixels. Levels of mipmaps are picked with it: a software rasteriser looks four pixels up
// at once only if they are of one level, which halves the time of the whole frame.
float quadNoise() { return fract(fract(52.9829189 * fract(dot(floor(0.5 * pixel()), vec2(0.06711056, 0.00583715)))) + chance.z); }
// Another, so that two decisions about one pixel have nothing to do with each other.
float otherPixelNoise() { return fract(fract(52.9829189 * fract(dot(pixel(), vec2(0.00583715, 0.06711056)))) + chance.y); }
