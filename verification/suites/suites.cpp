#include "verification/suites/suites.h"

namespace plumb {

Catalogue shipped_catalogue() {
    Catalogue catalogue;
    return catalogue;
}

}  // namespace plumb
