// The modules without GL as plain C functions: what wet-fur/core stands on, in browsers and Node.
#include "web/Boundary.h"
#include "furgen/FurVolume.h"
#include "scene/ImageDecode.h"
#include "settings/Settings.h"
#include "wet/WetnessMask.h"

using namespace fur;
using furgen::FurVolume;
using web::guarded;
using wet::WetnessMask;

namespace {

const bool describesFields = (settings::describeFieldsWith(settings::tooltipOf), true);

template <class T>
const void* bytesOf(const std::vector<T>& values, std::uint32_t& bytes) {
  bytes = std::uint32_t(values.size() * sizeof(T));
  return values.data();
}

// The channels by the order that core.js knows them in.
const void* channelBytes(const FurVolume& v, int channel, std::uint32_t& bytes) {
  switch (channel) {
    case 0: return bytesOf(v.coverage, bytes);
    case 1: return bytesOf(v.dominance, bytes);
    case 2: return bytesOf(v.variance, bytes);
    case 3: return bytesOf(v.tangent, bytes);
    case 4: return bytesOf(v.offset, bytes);
    case 5: return bytesOf(v.strandId, bytes);
    case 6: return bytesOf(v.finCoverage, bytes);
    case 7: return bytesOf(v.finVariance, bytes);
    case 8: return bytesOf(v.finTangent, bytes);
    case 9: return bytesOf(v.finDominance, bytes);
    default: return bytes = 0, nullptr;
  }
}

}  // namespace

// --- fur volume ---

// As many numbers as furDefaults of core.js has, in its order.
FUR_EXPORT FurVolume* fur_generate(const double* values) {
  return guarded([&] {
    furgen::FurParameters p;
    p.size = static_cast<int>(values[0]);
    p.layers = static_cast<int>(values[1]);
    p.seed = static_cast<std::uint32_t>(values[2]);
    values += 3;
    for (float furgen::FurParameters::*field :
         {&furgen::FurParameters::density, &furgen::FurParameters::thickness, &furgen::FurParameters::taper,
          &furgen::FurParameters::lengthVariation, &furgen::FurParameters::length, &furgen::FurParameters::curl,
          &furgen::FurParameters::wave, &furgen::FurParameters::coil, &furgen::FurParameters::frizz,
          &furgen::FurParameters::clump, &furgen::FurParameters::lockSize, &furgen::FurParameters::roll,
          &furgen::FurParameters::stray, &furgen::FurParameters::tipBreak, &furgen::FurParameters::undercoat,
          &furgen::FurParameters::undercoatLength})
      p.*field = static_cast<float>(*values++);
    return new FurVolume(furgen::generateFur(p));
  });
}
FUR_EXPORT void fur_volumeFree(FurVolume* volume) { delete volume; }
// size, layers, strandCount, density, weight, finRows
FUR_EXPORT const double* fur_volumeInfo(FurVolume* v) {
  return web::numbers({double(v->size), double(v->layers), double(v->strandCount), v->density, v->weight,
                       double(v->finRows)});
}
FUR_EXPORT const void* fur_volumeChannel(FurVolume* volume, int channel) {
  std::uint32_t bytes = 0;
  return channelBytes(*volume, channel, bytes);
}
FUR_EXPORT std::uint32_t fur_volumeChannelBytes(FurVolume* volume, int channel) {
  std::uint32_t bytes = 0;
  channelBytes(*volume, channel, bytes);
  return bytes;
}

// --- wetness mask ---

FUR_EXPORT WetnessMask* fur_maskCreate(int size) {
  return guarded([&] { return new WetnessMask(size); });
}
FUR_EXPORT void fur_maskFree(WetnessMask* mask) { delete mask; }
FUR_EXPORT void fur_maskAddDroplet(WetnessMask* mask, float u, float v, float radius, float wetness) {
  mask->addDroplet({{u, v}, radius, wetness});
}
FUR_EXPORT void fur_maskDryAt(WetnessMask* mask, float u, float v, float radius, float amount) {
  mask->dryAt({{u, v}, radius, amount});
}
FUR_EXPORT void fur_maskDry(WetnessMask* mask, float seconds, float rate) { mask->dry(seconds, rate); }
FUR_EXPORT void fur_maskClear(WetnessMask* mask) { mask->clear(); }
FUR_EXPORT int fur_maskSize(WetnessMask* mask) { return mask->size(); }
FUR_EXPORT const float* fur_maskTexels(WetnessMask* mask) { return &mask->texels().data()->x; }
FUR_EXPORT double fur_maskMean(WetnessMask* mask) { return mask->meanWetness(); }
FUR_EXPORT const double* fur_maskAt(WetnessMask* mask, float u, float v) {
  const Vec4 t = mask->at(u, v);
  return web::numbers({t.x, t.y, t.z, t.w});
}
FUR_EXPORT const char* fur_maskHash(WetnessMask* mask) { return web::hexadecimal(mask->hash()); }

// --- models ---

FUR_EXPORT scene::Model* fur_importModel(const std::uint8_t* bytes, std::uint32_t size, const char* name) {
  return guarded([&]() -> scene::Model* {
    scene::readAllFormats();
    Result<scene::Model> model = scene::importModel({bytes, size}, name, web::takeStagedFiles());
    if (model) return new scene::Model(std::move(*model));
    web::setError(model.error());
    return nullptr;
  });
}
FUR_EXPORT void fur_modelFree(scene::Model* model) { delete model; }
// vertexCount, triangleCount, hasTexcoords, bounds low x y z, high x y z
FUR_EXPORT const double* fur_modelInfo(scene::Model* m) {
  return web::numbers({double(m->mesh.positions.size()), double(m->mesh.triangleCount()), double(m->hasTexcoords),
                       m->bounds.low.x, m->bounds.low.y, m->bounds.low.z, m->bounds.high.x, m->bounds.high.y,
                       m->bounds.high.z});
}
// Of the base colour image, as it is encoded: bytes, width, height.
FUR_EXPORT const char* fur_modelImageType(scene::Model* m) { return m->baseColor().mimeType.c_str(); }
FUR_EXPORT const double* fur_modelImageInfo(scene::Model* m) {
  return web::numbers({double(m->baseColor().bytes.size()), double(m->baseColor().width), double(m->baseColor().height)});
}
FUR_EXPORT const std::uint8_t* fur_modelImageBytes(scene::Model* m) { return m->baseColor().bytes.data(); }
FUR_EXPORT const char* fur_modelWarnings(scene::Model* m) {
  std::string lines;
  for (const std::string& warning : m->warnings) lines += warning + '\n';
  return web::text(lines);
}

// --- images ---

FUR_EXPORT scene::Image* fur_decodeImage(const std::uint8_t* bytes, std::uint32_t size) {
  return guarded([&]() -> scene::Image* {
    Result<scene::Image> image = scene::decodeImage({bytes, size});
    if (image) return new scene::Image(std::move(*image));
    web::setError(image.error());
    return nullptr;
  });
}
FUR_EXPORT int fur_imageWidth(scene::Image* image) { return image->width; }
FUR_EXPORT int fur_imageHeight(scene::Image* image) { return image->height; }
FUR_EXPORT const std::uint8_t* fur_imagePixels(scene::Image* image) { return image->rgba.data(); }
FUR_EXPORT void fur_imageFree(scene::Image* image) { delete image; }
