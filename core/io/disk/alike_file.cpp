#include "core/io/disk/alike_file.h"

#include <algorithm>
#include <array>
#include <string>
#include <string_view>
#include <utility>

namespace brume {
namespace fs = std::filesystem;
namespace {

// Unicode's canonical decompositions of Latin, Greek, Cyrillic and Japanese letters into a letter
// and a mark: by mark, pairs of the composed letter and the one without.
constexpr std::array<std::pair<char32_t, std::u16string_view>, 27> compositions{{
    {0x0300, u"ÀAÈEÌIÒOÙUàaèeìiòoùuǛÜǜüǸNǹnЀЕЍИѐеѝиḔĒḕēṐŌṑōẀWẁwẦÂầâẰĂằăỀÊềêỒÔồôỜƠờơỪƯừưỲYỳy"},
    {0x0301,
     u"ÁAÉEÍIÓOÚUÝYáaéeíióoúuýyĆCćcĹLĺlŃNńnŔRŕrŚSśsŹZźzǗÜǘüǴGǵgǺÅǻåǼÆǽæǾØǿøΈΕΉΗΊΙΌΟΎΥΏΩΐϊάαέεήη"
     u"ίιΰϋόούυώωЃГЌКѓгќкḈÇḉçḖĒḗēḮÏḯïḰKḱkḾMḿmṌÕṍõṒŌṓōṔPṕpṸŨṹũẂWẃwẤÂấâẮĂắăẾÊếêỐÔốôỚƠớơỨƯứư"},
    {0x0302, u"ÂAÊEÎIÔOÛUâaêeîiôoûuĈCĉcĜGĝgĤHĥhĴJĵjŜSŝsŴWŵwŶYŷyẐZẑzẬẠậạỆẸệẹỘỌộọ"},
    {0x0303, u"ÃAÑNÕOãañnõoĨIĩiŨUũuṼVṽvẪÂẫâẴĂẵăẼEẽeỄÊễêỖÔỗôỠƠỡơỮƯữưỸYỹy"},
    {0x0304, u"ĀAāaĒEēeĪIīiŌOōoŪUūuǕÜǖüǞÄǟäǠȦǡȧǢÆǣæǬǪǭǫȪÖȫöȬÕȭõȰȮȱȯȲYȳyḠGḡgḸḶḹḷṜṚṝṛ"},
    {0x0306, u"ĂAăaĔEĕeĞGğgĬIĭiŎOŏoŬUŭuЎУЙИйиўуḜȨḝȩẶẠặạ"},
    {0x0307,
     u"ĊCċcĖEėeĠGġgİIŻZżzȦAȧaȮOȯoḂBḃbḊDḋdḞFḟfḢHḣhṀMṁmṄNṅnṖPṗpṘRṙrṠSṡsṤŚṥśṦŠṧšṨṢṩṣṪTṫtẆWẇwẊXẋxẎY"
     u"ẏyẛſ"},
    {0x0308, u"ÄAËEÏIÖOÜUäaëeïiöoüuÿyŸYΪΙΫΥϊιϋυЁЕЇІёеїіḦHḧhṎÕṏõṺŪṻūẄWẅwẌXẍxẗt"},
    {0x0309, u"ẢAảaẨÂẩâẲĂẳăẺEẻeỂÊểêỈIỉiỎOỏoỔÔổôỞƠởơỦUủuỬƯửưỶYỷy"},
    {0x030a, u"ÅAåaŮUůuẘwẙy"},
    {0x030b, u"ŐOőoŰUűu"},
    {0x030c, u"ČCčcĎDďdĚEěeĽLľlŇNňnŘRřrŠSšsŤTťtŽZžzǍAǎaǏIǐiǑOǒoǓUǔuǙÜǚüǦGǧgǨKǩkǮƷǯʒǰjȞHȟh"},
    {0x030f, u"ȀAȁaȄEȅeȈIȉiȌOȍoȐRȑrȔUȕu"},
    {0x0311, u"ȂAȃaȆEȇeȊIȋiȎOȏoȒRȓrȖUȗu"},
    {0x031b, u"ƠOơoƯUưu"},
    {0x0323,
     u"ḄBḅbḌDḍdḤHḥhḲKḳkḶLḷlṂMṃmṆNṇnṚRṛrṢSṣsṬTṭtṾVṿvẈWẉwẒZẓzẠAạaẸEẹeỊIịiỌOọoỢƠợơỤUụuỰƯựưỴYỵy"},
    {0x0324, u"ṲUṳu"},
    {0x0325, u"ḀAḁa"},
    {0x0326, u"ȘSșsȚTțt"},
    {0x0327, u"ÇCçcĢGģgĶKķkĻLļlŅNņnŖRŗrŞSşsŢTţtȨEȩeḐDḑdḨHḩh"},
    {0x0328, u"ĄAąaĘEęeĮIįiŲUųuǪOǫo"},
    {0x032d, u"ḒDḓdḘEḙeḼLḽlṊNṋnṰTṱtṶUṷu"},
    {0x032e, u"ḪHḫh"},
    {0x0330, u"ḚEḛeḬIḭiṴUṵu"},
    {0x0331, u"ḆBḇbḎDḏdḴKḵkḺLḻlṈNṉnṞRṟrṮTṯtẔZẕzẖh"},
    {0x3099,
     u"がかぎきぐくげけごこざさじしずすぜせぞそだたぢちづつでてどとばはびひぶふべへぼほゔうゞゝ"
     u"ガカギキグクゲケゴコザサジシズスゼセゾソダタヂチヅツデテドトバハビヒブフベヘボホヴウヷワ"
     u"ヸヰヹヱヺヲヾヽ"},
    {0x309a, u"ぱはぴひぷふぺへぽほパハピヒプフペヘポホ"},
}};

// Appends a character, taken apart into letter and marks.
void append_decomposed(char32_t c, std::u32string& text) {
  constexpr char32_t first_hangul = 0xac00;
  constexpr char32_t last_hangul = 0xd7a3;
  if (c >= first_hangul && c <= last_hangul) {  // syllables of 21 vowels and 28 ends
    const char32_t syllable = c - first_hangul;
    text += {0x1100 + syllable / (21 * 28), 0x1161 + syllable / 28 % 21};
    if (syllable % 28 != 0) text += 0x11a7 + syllable % 28;
    return;
  }
  for (const auto& [mark, pairs] : compositions) {
    for (std::size_t i = 0; i < pairs.size(); i += 2) {
      if (pairs[i] != c) continue;
      append_decomposed(pairs[i + 1], text);  // Vietnamese letters have two marks
      text += mark;
      return;
    }
  }
  text += c;
}

char32_t lower_case_letter(char32_t c) {
  const auto is_in = [c](char32_t first, char32_t last) { return c >= first && c <= last; };
  const bool is_upper = is_in('A', 'Z') || (is_in(0xc0, 0xde) && c != 0xd7) ||
                        is_in(0x391, 0x3a9) || is_in(0x410, 0x42f);
  return is_upper ? c + 0x20 : is_in(0x400, 0x40f) ? c + 0x50 : c;
}

// The character at `i` of UTF-8, and moves on behind it; a byte that belongs to none is one by
// itself.
char32_t next_character(std::string_view text, std::size_t& i) {
  const auto first = static_cast<unsigned char>(text[i++]);
  const std::size_t more = first >= 0xf0 ? 3 : first >= 0xe0 ? 2 : first >= 0xc0 ? 1 : 0;
  if (more == 0 || more > text.size() - i) return first;
  char32_t c = first & (0x3fu >> more);
  for (std::size_t k = 0; k < more; ++k) {
    c = c << 6 | (static_cast<unsigned char>(text[i + k]) & 0x3fu);
  }
  i += more;
  return c;
}

// A name of a file such that names alike become equal.
std::u32string folded(std::string_view name) {
  const std::size_t end = name.find_last_not_of(" \t") + 1;
  std::u32string text;
  for (std::size_t i = 0; i < end;) append_decomposed(next_character(name, i), text);
  std::ranges::transform(text, text.begin(), lower_case_letter);
  return text;
}

// The first, in the order of their bytes, of several entries that are alike.
fs::path entry_alike(const fs::path& folder, const fs::path& name) {
  const std::u32string wanted = folded(name.native());
  fs::path result;
  std::error_code error;
  for (fs::directory_iterator entry(folder.empty() ? "." : folder, error);
       !error && entry != fs::directory_iterator(); entry.increment(error)) {
    const fs::path found = entry->path().filename();
    if (folded(found.native()) == wanted && (result.empty() || found < result)) result = found;
  }
  return result.empty() ? name : result;
}

}  // namespace

fs::path find_file_named_alike(const fs::path& file) {
  std::error_code error;
  if (file.empty() || fs::exists(file, error)) return file;
  std::string text = file.native();
  std::ranges::replace(text, '\\', '/');
  fs::path result;
  for (const fs::path& part : fs::path(text).lexically_normal()) {
    const fs::path exact = result / part;
    result = fs::exists(exact, error) ? exact : result / entry_alike(result, part);
  }
  return fs::exists(result, error) ? result : file;
}

}  // namespace brume
