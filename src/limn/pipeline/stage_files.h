#pragma once

#include <optional>
#include <string>

#include "limn/linking/linking.h"
#include "limn/model/curve3d.h"
#include "limn/model/edge_map.h"

namespace limn {

// Results of stages on disk: little-endian, versioned, with a checksum, written to a temporary name
// and renamed. Every file holds a key, the text of all that it was made from; it is only taken for
// the result of the same key.
//
// Readers of the cache return nothing if there is no such file or it has another key or version,
// and throw IoError (path, byte, reason) if it is damaged.

// In stored pixels, before ApplyLens.
void WriteEdgeMapFile(const std::string& path, const std::string& key, const EdgeMap& edge_map);
std::optional<EdgeMap> ReadEdgeMapFile(const std::string& path, const std::string& key);

// In stored pixels, before ApplyLens.
void WriteFragmentsFile(const std::string& path, const std::string& key,
                        const LinkingResult& linked);
std::optional<LinkingResult> ReadFragmentsFile(const std::string& path, const std::string& key);

// A curve sketch with its support, and how it was made: the text of a JSON object of options.
struct StoredSketch {
  CurveSketch sketch;
  std::string options_json;
};

// The key is CurvesKey of what the sketch was made from. Unlike the cache, a sketch is asked for by
// name: reading throws IoError if it is missing or has another key.
void WriteSketchFile(const std::string& path, const std::string& key, const StoredSketch& stored);
StoredSketch ReadSketchFile(const std::string& path, const std::string& key);

}  // namespace limn
