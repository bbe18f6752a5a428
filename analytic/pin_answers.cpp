// Writes analytic/pinned_answers.inc: build the target pin_answers and run it there after a closed form has changed.

#include <fmt/format.h>

#include "analytic/closed_forms.h"

int main() {
    fmt::print(
        "// Written by pin_answers from the closed forms in analytic/formulas; a test holds them to each other.\n");
    for (const auto& [id, integral, variance] : plumb::evaluate_closed_forms())
        fmt::print("{{\"{}\",\n \"{}\",\n \"{}\"}},\n", id, integral, variance);
}
