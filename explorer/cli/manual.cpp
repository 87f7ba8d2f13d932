// delos manual: the program's own options as a manual page, or as a shell's completion.
#include <iostream>
#include <memory>

#include "command.h"

namespace delos::cli {
namespace {

/// Text of a manual page: lines as they are, what troff would take for a command or an
/// escape guarded.
std::string troff(const std::string& text) {
  std::string out;
  bool line_begins = true;
  for (const char c : text) {
    if (line_begins && (c == '.' || c == '\'')) out += "\\&";
    if (c == '\\')
      out += "\\e";
    else if (c == '-')
      out += "\\-";
    else
      out += c;
    line_begins = c == '\n';
  }
  return out;
}

void print_option(std::ostream& out, const CLI::Option& option) {
  const std::string name = option.get_name(true, true);
  if (name.empty() || name == "-h,--help") return;
  out << ".TP\n.B " << troff(name);
  if (option.get_type_size() > 0)
    out << " \\fI" << troff(option.get_type_name()) << "\\fR";
  out << "\n" << troff(option.get_description());
  if (const std::string initial = option.get_default_str(); !initial.empty())
    out << " (" << troff(initial) << ")";
  out << "\n";
}

void print_verbatim(std::ostream& out, const std::string& text) {
  if (!text.empty()) out << ".PP\n.nf\n" << troff(text) << "\n.fi\n";
}

void print_man_page(std::ostream& out, const CLI::App& program) {
  out << ".TH DELOS 1 \"\" \"delos " DELOS_VERSION "\" \"User commands\"\n"
      << ".SH NAME\ndelos \\- how well anything could be tracked with a rig of "
         "sensors\n"
      << ".SH SYNOPSIS\n.B delos\n\\fIcommand\\fR [\\fIoptions\\fR]\n"
      << ".SH DESCRIPTION\n"
      << troff(program.get_description()) << "\n.SH COMMANDS\n";
  for (const CLI::App* command : program.get_subcommands({})) {
    out << ".SS " << command->get_name() << "\n"
        << troff(command->get_description()) << ".\n";
    for (const CLI::Option* option : command->get_options()) print_option(out, *option);
    print_verbatim(out, command->get_footer());
  }
  out << ".SH EXAMPLES AND EXIT CODES\n";
  print_verbatim(out, program.get_footer());
}

/// All long options of a command, between blanks.
std::string words_of(const CLI::App& command) {
  std::string words;
  for (const CLI::Option* option : command.get_options())
    for (const std::string& name : option->get_lnames()) words += " --" + name;
  return words;
}

void print_bash_completion(std::ostream& out, const CLI::App& program) {
  out << "# Completion of delos for bash.\n_delos() {\n"
         "  local current=${COMP_WORDS[COMP_CWORD]} words=\n"
         "  case ${COMP_WORDS[1]} in\n";
  std::string names;
  for (const CLI::App* command : program.get_subcommands({})) {
    names += " " + command->get_name();
    out << "    " << command->get_name() << ") words='" << words_of(*command)
        << "' ;;\n";
  }
  out << "  esac\n"
         "  if [ \"$COMP_CWORD\" -eq 1 ]; then\n"
         "    COMPREPLY=($(compgen -W '"
      << names
      << "' -- \"$current\"))\n"
         "  elif [[ $current == -* ]]; then\n"
         "    COMPREPLY=($(compgen -W \"$words\" -- \"$current\"))\n"
         "  else\n"
         "    COMPREPLY=($(compgen -f -- \"$current\"))\n"
         "  fi\n"
         "}\n"
         "complete -o filenames -F _delos delos\n";
}

}  // namespace

void add_manual_command(CLI::App& program, int& exit_code) {
  auto form = std::make_shared<std::string>();
  CLI::App* app = program.add_subcommand(
      "manual", "These options as a manual page, or as a shell's completion");
  app->add_option("form", *form, "man or bash")
      ->required()
      ->check(CLI::IsMember({"man", "bash"}));
  app->footer(
      "Examples:\n"
      "  delos manual man | man -l -\n"
      "  source <(delos manual bash)");
  app->callback([form, &program, &exit_code] {
    if (*form == "man")
      print_man_page(std::cout, program);
    else
      print_bash_completion(std::cout, program);
    exit_code = kDone;
  });
}

}  // namespace delos::cli
