#pragma once

#include <string>

#include "integrators/references/provenance.h"
#include "scenes/mitsuba/mitsuba_xml.h"

namespace plumb {

/// The name and hash of a scene's file or shipped scene, with this program's version; the caller says the rest of the
/// provenance. Reads the file. Throws Error.
Provenance identity_of(const std::string& scene, const LoadOptions& options);
/// The same for a scene that is loaded.
Provenance identity_of(const std::string& scene, const description::Scene& loaded);

}  // namespace plumb
