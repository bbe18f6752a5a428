#pragma once

#include <string>

#include "integrators/references/provenance.h"
#include "scenes/mitsuba/mitsuba_xml.h"

namespace plumb {

/// Name, hash and this program's version for a scene's file or shipped name; the rest of it is for the caller to say.
/// Reads the file. Throws Error.
Provenance identity_of(const std::string& scene, const LoadOptions& options);
/// Of a scene that is loaded.
Provenance identity_of(const std::string& scene, const description::Scene& loaded);

}  // namespace plumb
