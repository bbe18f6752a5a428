#include "analytic/quadrature.h"

#include <chrono>
TEST(Quadrature, errs) {
    using namespace plumb;
    for (auto m : {Quadrature::gauss_legendre, Quadrature::tanh_sinh}) {
        double tot = 0;
        auto go = [&]<int D>() {
            for (const auto& f : integrands<D>()) {
                auto t = std::chrono::steady_clock::now();
                auto e = quadrature_errors<D>(std::span(&f, 1), m);
                double s = std::chrono::duration<double>(std::chrono::steady_clock::now() - t).count();
                tot += s;
                fmt::print("{} {} {:.2e} {:.2e} {:.3f}\n", to_string(m), f.id, e[0].integral, e[0].second_moment, s);
            }
        };
        go.operator()<1>();
        fmt::print("total {}\n", tot);
        go.operator()<2>();
        fmt::print("total {}\n", tot);
    }
}
