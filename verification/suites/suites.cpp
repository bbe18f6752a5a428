#include "verification/suites/suites.h"

namespace plumb {

Catalogue shipped_catalogue() {
    Catalogue catalogue;
    add_reweighting_2d_claims(catalogue);
    return catalogue;
}

}  // namespace plumb
