// Transcendental functions whose last bit is the same natively and in wasm (the C libraries
// differ), so that a seed gives the same bytes on every platform. Only + - * / and sqrt are used,
// which IEEE 754 fixes; the build forbids fused contraction (-ffp-contract=off).
#pragma once

namespace fur {

// sin(x), |x| <= 1e4, absolute error below 2e-7.
float portableSin(float x);
float portableCos(float x);
// ln(x) for x > 0, relative error below 1e-6.
float portableLog(float x);
// e^x for |x| <= 80, relative error below 1e-6.
float portableExp(float x);
// arctan(x) for finite x, relative error below 1e-6.
float portableAtan(float x);

}  // namespace fur
