#include <CLI/CLI.hpp>

#include "cli/verb.h"
#include "core/version.h"

namespace plumb::cli::verbs {
namespace {

// Text that troff prints as it stands.
std::string escaped(const std::string& text) {
    std::string safe;
    for (const char c : text) {
        if ((c == '.' || c == '\'') && (safe.empty() || safe.back() == '\n')) safe += "\\&";
        safe += c == '\\' ? "\\e" : c == '-' ? "\\-" : std::string(1, c);
    }
    return safe;
}

std::string option_text(const CLI::Option& option) {
    const std::string names = option.get_positional() ? option.get_name(true) : option.get_name(false, true);
    const std::string value = option.get_items_expected_max() > 0 && !option.get_positional() ? " VALUE" : "";
    return fmt::format(".TP\n.B {}{}\n{}\n", escaped(names), value, escaped(option.get_description()));
}

std::string verb_text(const CLI::App& verb) {
    std::string text = fmt::format(".SS {}\n{}.\n", verb.get_name(), escaped(verb.get_description()));
    for (const CLI::Option* option : verb.get_options()) text += option_text(*option);
    const std::string footer = verb.get_footer();
    return footer.empty() ? text : text + fmt::format(".PP\n.nf\n{}\n.fi\n", escaped(footer));
}

std::string man_page(const CLI::App& app) {
    std::string text = fmt::format(
        ".TH PLUMB 1 \"\" \"Plumb {}\"\n.SH NAME\nplumb \\- decides whether a Monte Carlo estimator is true\n"
        ".SH SYNOPSIS\n.B plumb\nVERB [OPTIONS]\n.SH VERBS\n",
        version);
    for (const CLI::App* verb : app.get_subcommands(nullptr)) text += verb_text(*verb);
    return text;
}

std::string bash_completion(const CLI::App& app) {
    std::string verbs, cases;
    for (const CLI::App* verb : app.get_subcommands(nullptr)) {
        verbs += verb->get_name() + ' ';
        std::string options;
        for (const CLI::Option* option : verb->get_options())
            for (const std::string& name : option->get_lnames()) options += "--" + name + ' ';
        cases += fmt::format("        {}) words='{}' ;;\n", verb->get_name(), options);
    }
    return fmt::format(
        "# Completion of plumb for bash; for zsh after `autoload bashcompinit; bashcompinit`.\n"
        "_plumb() {{\n"
        "    local word=${{COMP_WORDS[COMP_CWORD]}} words=\n"
        "    case \"${{COMP_WORDS[1]}}\" in\n{}    esac\n"
        "    if [ \"$COMP_CWORD\" -eq 1 ]; then words='{}'; fi\n"
        "    case \"$COMP_CWORD $word\" in 1*|*' -'*) mapfile -t COMPREPLY < <(compgen -W \"$words\" -- \"$word\") ;; "
        "esac\n"
        "}}\n"
        "complete -o default -F _plumb plumb\n",
        cases, verbs);
}

Action add(CLI::App& verb) {
    const auto completion = std::make_shared<bool>(false);
    verb.add_flag("--completion", *completion, "print a script that completes verbs and options in bash instead");
    verb.footer("Examples: plumb manual | man -l -\n          source <(plumb manual --completion)");
    return [completion, &verb](const Catalogue&) {
        const CLI::App& app = *verb.get_parent();
        fmt::print("{}", *completion ? bash_completion(app) : man_page(app));
        return 0;
    };
}

}  // namespace

Verb manual() {
    return {"manual", "Print the manual page of all verbs, or a script for completion", add};
}

}  // namespace plumb::cli::verbs
