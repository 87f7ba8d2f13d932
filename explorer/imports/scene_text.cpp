#include <cctype>

#include "delos/text/units.h"
#include "delos/text/words.h"
#include "imports/rig.h"

namespace delos::imports {
namespace {

constexpr std::size_t kLongest = 100;  // of a line of comments

/// A word of YAML, in quotes where it isn't plain.
std::string word_text(const std::string& word) {
  bool plain = !word.empty() && std::isalnum(static_cast<unsigned char>(word[0]));
  for (const char c : word)
    plain =
        plain && (std::isalnum(static_cast<unsigned char>(c)) || c == '_' || c == '-');
  if (plain && word != "null" && word != "Null" && word != "NULL") return word;
  std::string quoted = "\"";
  for (const char c : word) {
    if (c == '"' || c == '\\') quoted += '\\';
    quoted += static_cast<unsigned char>(c) < ' ' ? ' ' : c;
  }
  return quoted + "\"";
}

/// A sentence as comments, the lines after the first set in.
std::string comment(const std::string& sentence, const std::string& before = "# ") {
  std::string text, line = before;
  std::size_t begin = 0;
  while (begin < sentence.size()) {
    std::size_t end = sentence.find_first_of(" \n\r", begin);
    if (end == std::string::npos) end = sentence.size();
    std::string word = sentence.substr(begin, end - begin);
    for (char& c : word)
      if (static_cast<unsigned char>(c) < ' ') c = '-';
    if (line.size() + word.size() >= kLongest && line.size() > before.size() + 2) {
      text += line + "\n";
      line = "#   ";
    }
    line += (line.back() == ' ' ? "" : " ") + word;
    begin = end + 1;
  }
  return text + line + "\n";
}

std::string placement_text(const Placement& p, bool short_if_origin) {
  std::string text;
  if (!short_if_origin || !p.at.isZero(0)) text += ", at: " + list_text(p.at);
  if (const auto* rpy = std::get_if<Rpy>(&p.facing))
    text += ", rpy: " + list_text(rpy->angles);
  if (const auto* q = std::get_if<QuaternionWxyz>(&p.facing))
    text += ", quaternion_wxyz: " + list_text(q->wxyz);
  if (const auto* aim = std::get_if<Aim>(&p.facing))
    text += ", aim: " + list_text(aim->at);
  return text;
}

std::string device_text(const RigDevice& d) {
  std::string text =
      "  - {name: " + word_text(d.name) + ", type: " + d.type + ", rate: " + d.rate;
  if (!d.group.empty()) text += ", group: " + word_text(d.group);
  text += placement_text(d.placement, !d.group.empty());
  if (d.params.empty()) return text + "}\n";
  std::vector<std::string> params;
  for (const auto& [name, value] : d.params) params.push_back(name + ": " + value);
  return text + ",\n     params: {" + joined(params) + "}}\n";
}

std::string variable_text(const RigVariable& v) {
  std::string text = "  - {path: " + word_text(v.path);
  if (!v.lower.empty()) text += ", lower: " + v.lower + ", upper: " + v.upper;
  std::vector<std::string> ties;
  for (const std::string& tie : v.tie) ties.push_back(word_text(tie));
  if (!ties.empty()) text += ", tie: [" + joined(ties) + "]";
  return text + "}" + (v.remark.empty() ? "" : "   # " + scene_name(v.remark)) + "\n";
}

}  // namespace

std::string scene_text(const Rig& rig, const std::string& title,
                       const std::string& from) {
  std::string text = comment("Imported from " + from + ", a " + rig.kind + ": " +
                             counted(rig.devices.size(), "device") + ".");
  text += "#\n";
  for (const std::string& fact : rig.facts) text += comment(fact);
  if (!rig.assumed.empty()) {
    text +=
        "#\n# Assumed, since the file doesn't say it; change what you know better:\n";
    for (const std::string& each : rig.assumed) text += comment(each, "# - ");
  }
  text += "delos: 1\nname: " + word_text(title) + "\nmotion: " + rig.motion +
          "\nsample:\n  " + rig.sample + "\n";
  if (!rig.groups.empty()) text += "groups:\n";
  for (const Group& g : rig.groups)
    text += "  " + word_text(g.name) + ": {" +
            placement_text(g.placement, false).substr(2) + "}\n";
  text += "devices:";
  const std::string remark = rig.devices.empty() ? "" : rig.devices[0].rate_remark;
  text += remark.empty() ? "\n" : "   # rate " + remark + "\n";
  for (const RigDevice& d : rig.devices) text += device_text(d);
  if (!rig.occluders.empty()) text += "occluders:\n";
  for (const std::string& body : rig.occluders) text += "  - " + body + "\n";
  if (!rig.variables.empty()) text += "variables:\n";
  for (const RigVariable& v : rig.variables) text += variable_text(v);
  return text;
}

}  // namespace delos::imports
