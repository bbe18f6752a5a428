#include "cli/command_line.h"

#include <CLI/CLI.hpp>
#include <csignal>
#include <cstdio>
#include <cstring>
#include <filesystem>

#include "cli/session.h"
#include "core/error.h"
#include "core/version.h"

namespace plumb::cli {
namespace {

std::string program_name(const char* const* argv) {
    return std::filesystem::path(argv[0]).filename().string();
}

// An argument that looks like an option and is none; empty where there is no such argument.
std::string unreadable_argument(const CLI::App& verb, int argc, const char* const* argv) {
    for (int i = 2; i < argc && std::string_view(argv[i]) != "--"; ++i)
        if (argv[i][0] == '-' && std::strchr("-.0123456789", argv[i][1]) == nullptr &&
            !verb.get_option_no_throw(std::string(argv[i]).substr(0, 2)))
            return argv[i];
    return {};
}

// The first long option that the verb does not have; empty where there is none.
std::string unknown_option(const std::vector<std::string>& known, int argc, const char* const* argv) {
    for (int i = 1; i < argc; ++i) {
        const std::string typed = std::string(argv[i]).substr(0, std::string(argv[i]).find('='));
        if (typed.starts_with("--") && std::ranges::find(known, typed) == known.end()) return typed;
    }
    return {};
}

// CLI11 says "The following argument was not expected": name it, and the nearest known one.
std::string complaint_of(const CLI::App& app, const CLI::ParseError& error, int argc, const char* const* argv) {
    const CLI::App* verb = &app;
    for (const CLI::App* sub : app.get_subcommands()) verb = sub;
    std::vector<std::string> verbs, options;
    for (const CLI::App* sub : app.get_subcommands(nullptr)) verbs.push_back(sub->get_name());
    for (const CLI::Option* option : verb->get_options())
        for (const std::string& name : option->get_lnames()) options.push_back("--" + name);
    if (verb == &app && argc > 1 && argv[1][0] != '-') return unknown_name("verb", argv[1], verbs).what();
    if (const std::string found = unreadable_argument(*verb, argc, argv); !found.empty())
        return fmt::format("unknown option '{}'; what begins with - but is no option goes last, after --", found);
    if (dynamic_cast<const CLI::ExtrasError*>(&error))
        if (const std::string found = unknown_option(options, argc, argv); !found.empty())
            return unknown_name("option", found, options).what();
    return error.what();
}

std::string reason_of(const std::vector<Verb>& verbs, const CLI::App& app, const CLI::ParseError& error) {
    for (const Verb& verb : verbs)
        if (app.got_subcommand(verb.name) && verb.reason)
            if (const std::string reason = verb.reason(error); !reason.empty()) return ": " + reason;
    return {};
}

}  // namespace

int run_verb(int argc, const char* const* argv, const std::vector<Verb>& verbs, const Catalogue& catalogue) {
    const std::string name = program_name(argv);
    CLI::App app("Plumb decides whether a Monte Carlo estimator is true.", name);
    app.set_version_flag("--version", std::string(version));
    app.require_subcommand(1);
    app.footer(name + " VERB --help explains a verb, with an example.");
    std::map<std::string, Action> actions;
    bool quiet = false;
    for (const Verb& verb : verbs) {
        CLI::App& of = *app.add_subcommand(verb.name, verb.about);
        actions[verb.name] = verb.add(of);
        of.add_flag("--quiet", quiet, "say nothing but errors: the exit code and the files tell");
        of.set_version_flag("--version", std::string(version));
    }
    try {
        app.parse(argc, argv);
    } catch (const CLI::Success& answer) {
        return app.exit(answer);
    } catch (const CLI::ParseError& error) {
        fmt::print(stderr, "{}: {}{}\n", name, complaint_of(app, error, argc, argv), reason_of(verbs, app, error));
        return 2;
    }
    if (quiet) be_quiet();
    return actions.at(app.get_subcommands().front()->get_name())(catalogue);
}

int reporting_errors(const char* const* argv, const std::function<int()>& body) {
    std::signal(SIGXFSZ, SIG_IGN);  // a limit on file sizes is an error of writing like any other
    try {
        const int code = body();
        if (std::fflush(stdout) != 0) throw Error("cannot be written");
        return code;
    } catch (const std::exception& error) {
        fmt::print(stderr, "{}: {}{}\n", program_name(argv), std::ferror(stdout) ? "standard output: " : "",
                   error.what());
        return 2;
    }
}

}  // namespace plumb::cli
