#include <cstdio>

#include "estimators/estimator.h"

int main() {
    std::printf("%zu estimators\n", plumb::estimators_1d().size() + plumb::estimators_2d().size());
}
