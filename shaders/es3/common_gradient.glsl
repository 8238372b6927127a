// Half a step of noise, as smooth gradients band in 8 bits.
const vec2 kDither = vec2(0.75487767, 0.56984029);
float ditherStart() { return dot(vec2(0.0, bottomRow), kDither) + chance.w; }
float dither(vec2 pixel, float start) { return (fract(dot(pixel, kDither) + start) - 0.5) / 255.0; }

// The background's colour at the picture's foot, what is added to it to its top, and of the picture's height 1 and the framebuffer's lowest row, with
// ditherStart(). For vertices: a software rasteriser takes longer for members of a block than for the rest of the background.
mat3 gradientOfPicture() {
  return mat3(backgroundBottom.rgb, backgroundTop.rgb - backgroundBottom.rgb, vec3(vec2(1.0, bottomRow) / pictureHeight, ditherStart()));
}
// `y`: of the way up.
vec3 gradientAt(mat3 gradient, float y) { return gradient[0] + gradient[1] * (y * y * (3.0 - 2.0 * y)); }
vec3 gradientIn(mat3 gradient, vec2 pixel) { return gradientAt(gradient, pixel.y * gradient[2].x + gradient[2].y); }
