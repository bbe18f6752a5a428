#include "verification/suites/suites.h"

namespace plumb {

Catalogue shipped_catalogue() {
    Catalogue catalogue;
    add_integrand_claims(catalogue);
    add_reweighting_1d_claims(catalogue);
    return catalogue;
}

}  // namespace plumb
