#include "app/shell_help.h"

#include <CLI/CLI.hpp>
#include <algorithm>

#include "base/error.h"
#include "base/one_line.h"

namespace regarment {
namespace {

struct Choice {
  std::vector<std::string> names;    // "--quiet", or "-h" and "--help"
  std::string value;                 // of the manual: "FILE"; empty: a flag
  std::vector<std::string> allowed;  // values, where only some are
  std::string meaning;
  bool positional = false;
};

std::string replaced(std::string text, const std::string& from, const std::string& to) {
  for (std::size_t at = 0; (at = text.find(from, at)) != std::string::npos; at += to.size())
    text.replace(at, from.size(), to);
  return text;
}

// "TEXT:{auto,mm,cm}" allows three values.
std::vector<std::string> allowed_by(const std::string& type) {
  const auto open = type.find('{'), close = type.find('}');
  std::vector<std::string> out;
  if (open == std::string::npos || close == std::string::npos) return out;
  std::istringstream values(type.substr(open + 1, close - open - 1));
  for (std::string value; std::getline(values, value, ',');) out.push_back(value);
  return out;
}

std::vector<Choice> choices_of(const CLI::App& command) {
  std::vector<Choice> out;
  for (const CLI::Option* option : command.get_options()) {
    Choice choice;
    for (const std::string& name : option->get_snames()) choice.names.push_back("-" + name);
    for (const std::string& name : option->get_lnames()) choice.names.push_back("--" + name);
    choice.positional = choice.names.empty();
    if (choice.positional) choice.names.push_back(option->get_name(true));
    choice.meaning = one_line(option->get_description(), 1000);
    if (option->get_items_expected_max() > 0) {
      choice.allowed = allowed_by(option->get_type_name());
      choice.value =
          option->get_type_name().substr(0, option->get_type_name().find_first_of(":{ "));
      if (choice.value.empty()) choice.value = "VALUE";
    }
    out.push_back(choice);
  }
  return out;
}

std::vector<const CLI::App*> commands_of(const CLI::App& app) { return app.get_subcommands({}); }

std::string joined(const std::vector<std::string>& words, const std::string& between) {
  std::string out;
  for (const std::string& word : words) out += (out.empty() ? "" : between) + word;
  return out;
}

std::vector<std::string> names_of(const std::vector<const CLI::App*>& commands) {
  std::vector<std::string> out(commands.size());
  std::transform(commands.begin(), commands.end(), out.begin(),
                 [](const CLI::App* command) { return command->get_name(); });
  return out;
}

std::string bash_script(const CLI::App& app) {
  const auto commands = commands_of(app);
  std::string out =
      "# bash completion of regarment\n"
      "_regarment() {\n"
      "  local word=${COMP_WORDS[COMP_CWORD]} before=${COMP_WORDS[COMP_CWORD-1]}\n"
      "  local words=\n"
      "  if [ \"$COMP_CWORD\" -eq 1 ]; then\n"
      "    COMPREPLY=($(compgen -W '" +
      joined(names_of(commands), " ") +
      " --help --version' -- \"$word\"))\n"
      "    return\n"
      "  fi\n"
      "  case \"${COMP_WORDS[1]} $before\" in\n";
  for (const CLI::App* command : commands)
    for (const Choice& choice : choices_of(*command))
      for (const std::string& name : choice.names)
        if (!choice.positional && !choice.allowed.empty())
          out += "    '" + command->get_name() + " " + name + "') words='" +
                 joined(choice.allowed, " ") + "' ;;\n";
  out +=
      "  esac\n"
      "  if [ -n \"$words\" ]; then\n"
      "    COMPREPLY=($(compgen -W \"$words\" -- \"$word\"))\n"
      "    return\n"
      "  fi\n"
      "  case \"${COMP_WORDS[1]}\" in\n";
  for (const CLI::App* command : commands) {
    std::vector<std::string> options, places;
    for (const Choice& choice : choices_of(*command)) {
      auto& kind = choice.positional ? places : options;
      const auto& words = choice.positional ? choice.allowed : choice.names;
      kind.insert(kind.end(), words.begin(), words.end());
    }
    options.insert(options.end(), places.begin(), places.end());
    out += "    " + command->get_name() + ") words='" + joined(options, " ") + "' ;;\n";
  }
  out +=
      "  esac\n"
      "  COMPREPLY=($(compgen -W \"$words\" -- \"$word\"))\n"
      "  [[ $word == -* ]] || COMPREPLY+=($(compgen -f -- \"$word\"))\n"
      "}\n"
      "complete -o filenames -F _regarment regarment\n";
  return out;
}

std::string in_quotes(const std::string& text) { return "'" + replaced(text, "'", "'\\''") + "'"; }

std::string zsh_script(const CLI::App& app) {
  std::string out =
      "#compdef regarment\n"
      "# zsh completion of regarment\n"
      "local -a commands\n"
      "commands=(\n";
  const auto plain = [](const std::string& text) {
    return replaced(replaced(replaced(text, ":", "\\:"), "[", "("), "]", ")");
  };
  for (const CLI::App* command : commands_of(app))
    out += "  " + in_quotes(command->get_name() + ":" + plain(command->get_description())) + "\n";
  out +=
      ")\n"
      "if (( CURRENT == 2 )); then\n"
      "  _describe command commands\n"
      "  return\n"
      "fi\n"
      "local command=$words[2]\n"
      "shift words\n"
      "(( CURRENT-- ))\n"
      "case $command in\n";
  for (const CLI::App* command : commands_of(app)) {
    out += "  " + command->get_name() + ")\n    _arguments";
    for (const Choice& choice : choices_of(*command)) {
      const std::string values =
          choice.allowed.empty() ? "_files" : "(" + joined(choice.allowed, " ") + ")";
      const bool takes = choice.positional || !choice.value.empty();
      for (const std::string& name : choice.names) {
        std::string words = "*";
        if (!choice.positional) words.append(name).append("[").append(plain(choice.meaning)) += "]";
        const std::string& what = choice.positional ? name : choice.value;
        if (takes) words.append(":").append(plain(what)).append(":").append(values);
        out.append(" \\\n      ").append(in_quotes(words));
      }
    }
    out += "\n    ;;\n";
  }
  return out + "esac\n";
}

std::string fish_script(const CLI::App& app) {
  std::string out = "# fish completion of regarment\n";
  for (const CLI::App* command : commands_of(app)) {
    out += "complete -c regarment -n __fish_use_subcommand -f -a " + command->get_name() + " -d " +
           in_quotes(command->get_description()) + "\n";
    for (const Choice& choice : choices_of(*command)) {
      if (choice.positional) continue;
      out += "complete -c regarment -n '__fish_seen_subcommand_from " + command->get_name() + "'";
      for (const std::string& name : choice.names)
        out += name.starts_with("--") ? " -l " + name.substr(2) : " -s " + name.substr(1);
      if (!choice.allowed.empty())
        out += " -x -a " + in_quotes(joined(choice.allowed, " "));
      else if (!choice.value.empty())
        out += " -r";
      out += " -d " + in_quotes(choice.meaning) + "\n";
    }
  }
  return out;
}

// A line of text for roff: no escapes, no requests, no hyphens where minus signs are meant.
std::string roff(const std::string& text) {
  std::string out = replaced(replaced(text, "\\", "\\e"), "-", "\\-");
  return out.starts_with(".") || out.starts_with("'") ? "\\&" + out : out;
}

}  // namespace

CLI::App* add_completion(CLI::App& app, std::string& shell) {
  CLI::App* completion =
      app.add_subcommand("completion", "A script by which a shell completes commands and options");
  completion->add_option("SHELL", shell, "bash, zsh or fish")
      ->required()
      ->check(CLI::IsMember({"bash", "zsh", "fish"}));
  return completion;
}

CLI::App* add_manual(CLI::App& app) {
  return app.add_subcommand("manual", "The manual page, for man -l or the manual's folder");
}

std::string completion_script(const CLI::App& app, const std::string& shell) {
  if (shell == "bash") return bash_script(app);
  if (shell == "zsh") return zsh_script(app);
  if (shell == "fish") return fish_script(app);
  throw UsageError("completion: '" + one_line(shell, 60) +
                   "' is no shell known here; use bash, zsh or fish");
}

std::string manual_page(const CLI::App& app, const std::string& version) {
  std::string out = ".TH REGARMENT 1 \"\" \"regarment " + roff(version) +
                    "\" \"User Commands\"\n.SH NAME\nregarment \\- " + roff(app.get_description()) +
                    "\n.SH SYNOPSIS\n.B regarment\n.I COMMAND\n[" +
                    "\\fIARGUMENTS\\fR] [\\fIOPTIONS\\fR]\n.SH COMMANDS\n";
  for (const CLI::App* command : commands_of(app)) {
    out += ".SS regarment " + roff(command->get_name());
    for (const Choice& choice : choices_of(*command))
      if (choice.positional) out += " " + roff(choice.names.front());
    out += "\n" + roff(command->get_description()) + ".\n";
    for (const Choice& choice : choices_of(*command)) {
      out += ".TP\n\\fB" + roff(joined(choice.names, ", ")) + "\\fR";
      if (!choice.positional && !choice.value.empty()) out += " \\fI" + roff(choice.value) + "\\fR";
      out += "\n" + roff(choice.meaning) + ".\n";
      if (!choice.allowed.empty()) out += "One of: " + roff(joined(choice.allowed, ", ")) + ".\n";
    }
  }
  return out + ".SH EXIT STATUS\n" + roff(replaced(app.get_footer(), "\n", " ")) + "\n";
}

}  // namespace regarment
