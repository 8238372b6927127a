// Kinds of files by the endings of their names. Formats.inc is the only place that lists them.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

namespace fur::scene {

enum class FileKind { Model, Coat, Hair, Picture, Companion };

enum class Format {
#define FUR_MODEL_FORMAT(id, ...) id,
#define FUR_FORMAT(id, ...) id,
#include "scene/Formats.inc"
#undef FUR_MODEL_FORMAT
#undef FUR_FORMAT
};
inline constexpr std::size_t kFormatCount = 0
#define FUR_MODEL_FORMAT(...) +1
#define FUR_FORMAT(...) +1
#include "scene/Formats.inc"
#undef FUR_MODEL_FORMAT
#undef FUR_FORMAT
    ;

FileKind kindOf(Format format);
// ".jpg": the usual one.
std::string_view endingOf(Format format);
// By the ending of a file's name, in small letters or capitals; none: of no format that is known.
std::optional<Format> formatNamed(std::string_view fileName);
// Whether the name's ending is one of that kind.
bool isNamedAs(FileKind kind, std::string_view fileName);
// As ".glb, .gltf and .obj"; `joint`: before the last.
std::string endingsOf(FileKind kind, std::string_view joint = " and ");
// "Save scene (.glb)", for a button.
std::string saveLabel(Format format);

}  // namespace fur::scene
