#pragma once

#include <functional>
#include <string>
#include <vector>

namespace CLI {
class App;
class ParseError;
}  // namespace CLI

namespace plumb {
class Catalogue;
}

namespace plumb::cli {

/// The action of a verb once its options are read: it works, prints to standard output and returns the program's exit
/// code. The catalogue is the program's. Throws Error.
using Action = std::function<int(const Catalogue&)>;

/// A word of the command line: one file in verbs/, and its name in one of the lists of CMakeLists.txt.
struct Verb {
    std::string name, about;
    /// Describes the verb's options to CLI11; the action owns the values that they are read into.
    Action (*add)(CLI::App& verb);
    /// The part that a complaint of CLI11 lacks, e.g. why two options exclude each other; empty where nothing is
    /// missing.
    std::string (*reason)(const CLI::ParseError& error) = nullptr;
};

/// The verbs that need nothing but a catalogue, in the order in which help lists them.
std::vector<Verb> catalogue_verbs();
/// The verbs of the program that Plumb ships.
std::vector<Verb> shipped_verbs();

}  // namespace plumb::cli
