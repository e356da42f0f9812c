// Tests layouts: tables of any columns, read by a description in JSON, and the proposals of such layouts.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "io/columns/layout.h"
#include "io/formats/describe_table.h"
#include "io/samples/aperture.h"
#include "tests/io/reading.h"

namespace brdf::io {
namespace {

using testing::AllOf;
using testing::Contains;
using testing::DoubleNear;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

constexpr const char* kOpen = R"({"format": "brdf-layout", "version": 1, )";

// A laboratory's table: titles, words in another language, decimal commas, an uncertainty in percent with
// the coverage factor 2, and a number for "not measured".
const std::string kLab =
    "Messplatz A\n"
    "Einfall;Azimut E;Ausfall;Azimut A;Messwert;u;Bemerkung\n"
    "30,0;0;10,0;180;0,25;2,0;erste\n"
    "30,0;0;20,0;180;-999;2,0;Blende\n"
    "30,0;0;40,0;90;0,5;1,0;letzte\n";
const std::string kLabColumns =
    R"("columns": [{"name": "Einfall", "is": "theta_i"}, {"name": "Azimut E", "is": "phi_i"},
       {"name": "Ausfall", "is": "theta_o"}, {"name": "Azimut A", "is": "phi_o"},
       {"name": "Messwert", "is": "value"}, {"name": "u", "is": "sigma", "relative": "%", "coverage": 2},
       {"name": "Bemerkung", "is": "ignored"}])";
const std::string kLabLayout =
    kOpen + (R"("quantity": "BRF", "fill": [-999], "aperture": 1.5, )" + kLabColumns + "}");

SampleTable read_by(const std::string& layout, const std::string& text, const std::string& quantity = "",
                    MirrorSide side = MirrorSide::automatic) {
  return read_samples(Content{"lab.txt", text}, {quantity, side, false, layout});
}

std::string layout_refusal(const std::string& layout, const std::string& text = kLab) {
  return message_of([&] { read_by(layout, text); });
}

// A layout of three columns for tables `a b c`.
std::string layout_of(const std::string& entries, const std::string& keys = R"("quantity": "f_r", )") {
  return kOpen + keys + R"("columns": [)" + entries + "]}";
}
const std::string kThree =
    R"({"name": "a", "is": "theta_i"}, {"name": "b", "is": "theta_o"}, {"name": "c", "is": "value"})";
const std::string kAbc = "a,b,c\n30,-10,0.1\n30,30,0.9\n30,50,0.2\n";

TEST(Layout, ReadsATableWhoseWordsAreNotUnderstood) {
  EXPECT_THAT(message(kLab), HasSubstr("missing")) << "the table must need its layout";
  const SampleTable t = read_by(kLabLayout, kLab);
  EXPECT_THAT(t.theta_i, ElementsAre(30, 30));
  EXPECT_THAT(t.theta_o, ElementsAre(10, 40));
  EXPECT_THAT(t.phi_o, ElementsAre(180, 90));
  EXPECT_THAT(t.channels, ElementsAre("fr"));
  EXPECT_THAT(t.values[0], ElementsAre(DoubleNear(0.25 / kPi, 1e-15), DoubleNear(0.5 / kPi, 1e-15)));
  // 2 % and 1 % at a coverage factor of 2 are 1 % and 0.5 %.
  EXPECT_THAT(t.sigma[0], ElementsAre(DoubleNear(0.0025 / kPi, 1e-15), DoubleNear(0.0025 / kPi, 1e-15)));
  EXPECT_EQ(t.skipped, 1u);
  EXPECT_THAT(t.warnings, Contains("1 row with a fill value of the layout left out"));
  EXPECT_EQ(stated_aperture(t), 1.5);
  EXPECT_THAT(t.assumptions, Contains(HasSubstr("is a reflectance factor: divided by pi")));
}

TEST(Layout, ColumnsByPositionWithoutAHeaderRow) {
  const std::string layout = layout_of(
      R"({"position": 2, "is": "theta_i", "unit": "rad"}, {"constant": 0, "is": "phi_i"},
         {"position": 1, "is": "theta_o", "from": "surface"}, {"constant": 0, "is": "phi_o"},
         {"position": 4, "is": "value", "channel": "green"})",
      R"("header": 0, "separator": "blanks", "comment": "%", "mirror_azimuth": 0, "quantity": "f_r", )");
  const SampleTable t = read_by(layout, "% made by hand\n60 0.5235987755982988 7 0.125\n");
  EXPECT_THAT(t.theta_i, ElementsAre(30));
  EXPECT_THAT(t.theta_o, ElementsAre(30));
  EXPECT_EQ(t.phi_o[0] - t.phi_i[0], -180) << "the mirror direction of the file is at equal azimuths";
  EXPECT_THAT(t.channels, ElementsAre("green"));
  EXPECT_EQ(t.values[0][0], 0.125);
  EXPECT_THAT(t.warnings, Contains("not in the layout, and ignored: 'column 3'"));
}

TEST(Layout, WavelengthsMakeChannels) {
  const std::string layout = layout_of(kThree + R"(, {"name": "band", "is": "wavelength", "unit": "um"})");
  const SampleTable t =
      read_by(layout, "a,b,c,band\n30,30,0.9,0.45\n30,30,0.8,0.55\n", "", MirrorSide::positive);
  EXPECT_THAT(t.channels, ElementsAre("450nm", "550nm"));
  EXPECT_EQ(t.rows(), 1u);
  const SampleTable one =
      read_by(layout_of(kThree + R"(, {"constant": 532, "is": "wavelength", "unit": "nm"})"), kAbc);
  EXPECT_THAT(one.channels, ElementsAre("532nm"));
  EXPECT_EQ(one.rows(), 3u);
}

TEST(Layout, TheMirrorSideOfTwoSignedAngles) {
  const SampleTable positive =
      read_by(layout_of(kThree, R"("quantity": "f_r", "mirror_side": "positive", )"), kAbc);
  const SampleTable negative =
      read_by(layout_of(kThree, R"("quantity": "f_r", "mirror_side": "negative", )"), kAbc);
  EXPECT_THAT(positive.phi_o, ElementsAre(180, 0, 0));
  EXPECT_THAT(negative.phi_o, ElementsAre(0, 180, 180));
  EXPECT_EQ(positive.phi_i, negative.phi_i);
}

TEST(Layout, ARotationIsSubtracted) {
  const SampleTable t = read_by(
      layout_of(
          R"({"name": "a", "is": "theta_i"}, {"constant": 10, "is": "phi_i"}, {"name": "b", "is": "theta_o"},
                   {"constant": 190, "is": "phi_o"}, {"name": "c", "is": "value"},
                   {"name": "turn", "is": "rotation"})"),
      "a,b,c,turn\n30,20,0.5,45\n");
  EXPECT_EQ(t.phi_i[0], -35);
  EXPECT_EQ(t.phi_o[0], 145);
}

TEST(Layout, ARowOfUnitsBelowTheNamesIsSkipped) {
  EXPECT_EQ(read_by(layout_of(kThree), "a,b,c\ndeg,deg,1/sr\n30,30,0.9\n").rows(), 1u);
}

TEST(Layout, AColumnThatTheTableLacksNamesTheColumnsOfTheTable) {
  EXPECT_THAT(layout_refusal(replaced(kLabLayout, "\"Ausfall\"", "\"Ausfal\"")),
              AllOf(HasSubstr("layout: $.columns[2].name: the table has no column 'Ausfal': "),
                    HasSubstr("did you mean Ausfall?"),
                    HasSubstr("the header row (lab.txt, line 2) has the columns: "),
                    HasSubstr("'Einfall', 'Azimut E', 'Ausfall'")));
  EXPECT_THAT(layout_refusal(layout_of(R"({"position": 9, "is": "theta_i"}, {"name": "b", "is": "theta_o"},
                                   {"name": "c", "is": "value"})"),
                             kAbc),
              HasSubstr("$.columns[0].position: 9 must be at most 3 columns"));
  EXPECT_THAT(layout_refusal(layout_of(kThree), "a,b,c,c\n30,30,1,1\n"),
              HasSubstr("'c' is the name of 2 columns: give the \"position\""));
}

TEST(Layout, UnknownKeysAndKeysWithoutEffectAreRefused) {
  EXPECT_THAT(layout_refusal(layout_of(kThree, R"("quantity": "f_r", "units": "deg", )")),
              HasSubstr("layout: $: unknown key \"units\""));
  EXPECT_THAT(layout_refusal(layout_of(R"({"name": "a", "is": "theta_i", "scale": 2})")),
              HasSubstr("unknown key \"scale\""));
  EXPECT_THAT(
      layout_refusal(layout_of(R"({"name": "a", "is": "value", "unit": "deg"})")),
      HasSubstr("$.columns[0].unit: \"deg\" has no effect on an entry that is value; remove the key"));
  EXPECT_THAT(layout_refusal(layout_of(kThree, R"("quantity": "f_r", "mirror_azimuth": 0, )")),
              HasSubstr("$.mirror_azimuth: 0 has no effect: the layout has no azimuths"));
  EXPECT_THAT(layout_refusal(replaced(kLabLayout, "\"fill\"", "\"mirror_side\": \"positive\", \"fill\"")),
              HasSubstr("$.mirror_side: \"positive\" has no effect: azimuths"));
  EXPECT_THAT(
      layout_refusal(layout_of(replaced(kThree, R"("is": "value")", R"("is": "value", "quantity": "BRF")"))),
      HasSubstr("$.quantity: \"f_r\" has no effect"));
  EXPECT_THAT(
      layout_refusal(layout_of(replaced(kThree, R"("is": "value")", R"("is": "value", "channel": "x")") +
                               R"(, {"name": "w", "is": "wavelength", "unit": "nm"})")),
      HasSubstr("$.columns[2].channel: has no effect: the wavelengths name the channels"));
  EXPECT_THAT(layout_refusal(layout_of(R"({"name": "a", "is": "theta_i"})", R"("header": 0, )")),
              HasSubstr("$.columns[0].name: \"a\" cannot be found, because \"header\" is 0"));
}

TEST(Layout, IncompleteDirectionsAreRefused) {
  EXPECT_THAT(layout_refusal(layout_of(R"({"name": "a", "is": "theta_i"}, {"name": "c", "is": "value"})")),
              HasSubstr("layout: $.columns: no entry is theta_o; add the column"));
  EXPECT_THAT(
      layout_refusal(layout_of(kThree + R"(, {"name": "d", "is": "phi_o"})")),
      HasSubstr(
          "no entry is phi_i, but the other azimuth is given: add {\"constant\": 0, \"is\": \"phi_i\"}"));
  EXPECT_THAT(layout_refusal(layout_of(kThree + R"(, {"name": "d", "is": "theta_o"})")),
              HasSubstr("$.columns[3]: is theta_o, as $.columns[1] is"));
  EXPECT_THAT(layout_refusal(layout_of(kThree + R"(, {"name": "a", "is": "ignored"})")),
              HasSubstr("$.columns[3]: is the column of $.columns[0]"));
  EXPECT_THAT(layout_refusal(layout_of(R"({"name": "a", "position": 1, "is": "theta_i"})")),
              HasSubstr("must have exactly one of"));
}

TEST(Layout, TheQuantityIsNeverGuessed) {
  EXPECT_THAT(layout_refusal(layout_of(kThree, ""), kAbc),
              HasSubstr("layout: $: key \"quantity\" is missing"));
  EXPECT_THAT(layout_refusal(layout_of(kThree, R"("quantity": "transmittance", )"), kAbc),
              HasSubstr("$.quantity: \"transmittance\" is of transmitted light, not f_r"));
  EXPECT_THAT(layout_refusal(layout_of(kThree), "# quantity: BRF\n" + kAbc),
              HasSubstr("the quantity 'BRF' contradicts $.quantity of layout"));
  // The file, or the option, may state the quantity that the layout leaves out.
  EXPECT_EQ(read_by(layout_of(kThree, ""), "# quantity: f_r\n" + kAbc).values[0][0], 0.1);
  EXPECT_EQ(read_by(layout_of(kThree, ""), kAbc, "f_r").values[0][0], 0.1);
  EXPECT_THAT(message_of([] { read_by(layout_of(kThree), kAbc, "BRF"); }),
              HasSubstr("lab.txt: --quantity BRF: layout states the quantity, too"));
}

TEST(Layout, AnUnsurePlaceIsRefusedUntilItIsFilled) {
  const std::string unsure =
      R"(, "unsure": [{"path": "$.columns[2].is", "reason": "the name 'c' is not understood"}]})";
  std::string layout = layout_of(replaced(kThree, "\"value\"", "null"));
  layout.pop_back();
  EXPECT_THAT(layout_refusal(layout + unsure),
              AllOf(HasSubstr("layout: $.columns[2].is: null must be replaced by one of theta_i, phi_i"),
                    HasSubstr("the place is unsure: the name 'c' is not understood")));
  layout = layout_of(kThree);
  layout.pop_back();
  EXPECT_THAT(
      read_by(layout + unsure, kAbc).assumptions,
      Contains(
          "the layout's $.columns[2].is is a proposal that may be wrong: the name 'c' is not understood"));
  EXPECT_THAT(layout_refusal(layout + R"(, "unsure": [{"path": "$.columns[7].is", "reason": "x"}]})", kAbc),
              HasSubstr("$.unsure[0].path: \"$.columns[7].is\" must be the path of a place in this layout"));
}

TEST(Layout, OnlyTablesOfTextHaveALayout) {
  const auto refused = [](const std::string& bytes) {
    return message_of([&] { read_samples(Content{"x", bytes}, {.layout = layout_of(kThree)}); });
  };
  EXPECT_THAT(refused("{\"a\": 1}"),
              HasSubstr("x: --layout applies to tables of columns of text, and this file is JSON"));
  EXPECT_EQ(refused(kAbc), "accepted");
  EXPECT_THAT(refused(kAstm), HasSubstr("; the file is in the format astm, whose reader needs no layout"));
}

// Returns the paths of a proposal's unsure places.
std::vector<std::string> unsure_paths(const TableProposal& proposal) {
  std::vector<std::string> paths;
  if (proposal.layout.contains("unsure"))
    for (const Json& entry : proposal.layout["unsure"]) paths.push_back(entry["path"]);
  return paths;
}

TEST(Proposal, ReadsTheSameRowsAsTheTableAlone) {
  for (const std::string& text :
       {std::string("theta_i,phi_i,theta_o,phi_o,r,g\n30,0,20,180,.1,.2\n40,0,20,90,.3,.4\n"),
        std::string("# quantity: BRF %\nAOI;Azimuth i;Detector angle;phi_o;550nm;650nm\n30;0;20;180;1,5;2\n"),
        std::string("AOI (deg),Scatter angle (deg),BRDF (1/sr),temperature (K)\n") +
            "30,-40,.1,293\n30,0,.1,293\n30,30,.9,294\n30,50,.2,294\n",
        std::string("Titel\nthetai phi_i thetar phi_r lambda fr\n30 0 20 180 .55 .1\n30 0 20 180 .65 .2\n"),
        std::string("theta_i,phi_i,theta_o,phi_o,BRF,sigma_BRF\n30,0,20,180,.3,.01\n30,0,40,180,.4,.02\n"),
        std::string("elevation_i,phi_i,theta_o [rad],phi_o,log10 BRDF\n60,0,.5,180,-1\n30,0,.25,90,-2\n"),
        std::string("theta_i,theta_o,phi,polarisation,fr\n30,20,180,s,.1\n30,20,180,p,.2\n"),
        std::string("AOI,30\nScatter angle (deg),BRDF (1/sr)\n-20,.1\n0,.1\n30,.9\n"),
        std::string("theta_i (deg);theta_o (deg);f_r\n-30;30;0,9\n-30;-20;0,1\n-30;0;0,1\n")}) {
    const TableProposal proposal = propose_layout(Content{"t", text});
    ASSERT_TRUE(proposal.alone) << text << proposal.refusal;
    EXPECT_EQ(proposal.open, 0u) << to_text(proposal.layout);
    SCOPED_TRACE(to_text(proposal.layout));
    const SampleTable again = read_samples(Content{"t", text}, {.layout = to_line(proposal.layout)});
    const SampleTable alone = read(text);
    EXPECT_EQ(again.channels, alone.channels);
    EXPECT_EQ(again.theta_i, alone.theta_i);
    EXPECT_EQ(again.phi_i, alone.phi_i);
    EXPECT_EQ(again.theta_o, alone.theta_o);
    EXPECT_EQ(again.phi_o, alone.phi_o);
    EXPECT_EQ(again.values, alone.values);
    EXPECT_EQ(again.sigma, alone.sigma);
  }
}

TEST(Proposal, NamesThePlacesThatItIsUnsureOf) {
  const TableProposal plane =
      propose_layout(Content{"t", "AOI,Scatter angle,value,temperature\n.5,-.4,.1,293\n.5,.5,.9,293\n"});
  EXPECT_THAT(unsure_paths(plane), AllOf(Contains("$.quantity"), Contains("$.mirror_side"),
                                         Contains("$.columns[0].unit"), Contains("$.columns[3].is")));
  const TableProposal sure = propose_layout(
      Content{"t", "# quantity: f_r\ntheta_i,phi_i,theta_o,phi_o,r\n30,0,20,180,.1\n30,0,50,180,.1\n"});
  EXPECT_THAT(unsure_paths(sure), IsEmpty());
}

TEST(Proposal, LeavesOpenWhatItDoesNotUnderstand) {
  const TableProposal proposal = propose_layout(Content{"lab.txt", kLab});
  EXPECT_FALSE(proposal.alone);
  EXPECT_GT(proposal.open, 0u);
  const Json& columns = proposal.layout["columns"];
  ASSERT_EQ(columns.size(), 7u);
  EXPECT_EQ(columns[0]["name"], "Einfall");
  EXPECT_TRUE(columns[0]["is"].is_null());
  EXPECT_EQ(proposal.layout["decimal"], ",");
  EXPECT_THAT(layout_refusal(to_line(proposal.layout)),
              AllOf(HasSubstr("layout: $.columns[0].is: null must be replaced by one of theta_i"),
                    HasSubstr("the name 'Einfall' is not understood; the column holds the number 30 only")));
}

TEST(Proposal, AsksForTheQuantityOfAReflectance) {
  const std::string text = "theta_i,phi_i,theta_o,phi_o,reflectance (%)\n30,0,20,180,12\n30,0,40,180,13\n";
  EXPECT_THAT(message(text), HasSubstr("reflectance"));
  TableProposal proposal = propose_layout(Content{"t", text});
  EXPECT_EQ(proposal.open, 1u);
  EXPECT_THAT(unsure_paths(proposal), Contains("$.columns[4].quantity"));
  EXPECT_THAT(message_of([&] {
                read_samples(Content{"t", text}, {.layout = to_line(proposal.layout)});
              }),
              HasSubstr("$.columns[4].quantity: null must be replaced by a quantity: f_r, BRF"));
  proposal.layout["columns"][4]["quantity"] = "BRF %";
  const SampleTable t = read_samples(Content{"t", text}, {.layout = to_line(proposal.layout)});
  EXPECT_THAT(t.values[0][0], DoubleNear(0.12 / kPi, 1e-15));
}

TEST(Proposal, ColumnsOfATableWithoutAHeaderRowGetPositions) {
  const TableProposal proposal = propose_layout(Content{"t", "30 20 180 .5\n30 40 180 .6\n"});
  EXPECT_EQ(proposal.layout["header"], 0);
  EXPECT_EQ(proposal.layout["columns"][3]["position"], 4);
  EXPECT_EQ(proposal.open, 4u);
}

// A thousand distinct numbers of a column are counted, and fill values behind them.
TEST(Proposal, MoreNumbersThanAreCountedAreAtLeastSoMany) {
  std::string text;
  for (int k = 0; k < 1200; ++k) text += "30 " + std::to_string(0.01 * k) + " 180\n";
  EXPECT_THAT(to_line(propose_layout(Content{"t", text}).layout["unsure"]),
              HasSubstr("column 2 holds at least 1000 different numbers from 0 to 11.99"));
  EXPECT_THAT(to_line(propose_layout(Content{"t", text + "30 -9999 180\n"}).layout["unsure"]),
              HasSubstr("column 2 holds at least 1001 different numbers from -9999 to 11.99"));
}

// Quotation marks are removed from fields, which then have memory of their own.
TEST(Proposal, ARowOfUnitsInQuotesIsNoHeaderRow) {
  const TableProposal proposal = propose_layout(
      Content{"t", "\"Einfall 1\";\"Ausfall 1\";\"Signal\"\n\"(deg)\";\"(deg)\";\"-\"\n30;40;2\n30;50;3\n"});
  ASSERT_EQ(proposal.layout["columns"].size(), 3u);
  EXPECT_EQ(proposal.layout["columns"][1]["name"], "Ausfall 1");
}

TEST(Proposal, WordsAmongNumbersAreFillValues) {
  const std::string text =
      "theta_i,phi_i,theta_o,phi_o,fr\n30,0,20,180,.5\n30,0,40,180,n/a\n30,0,50,180,9999\n30,0,60,180,9999\n";
  EXPECT_NE(message(text), "accepted");
  const TableProposal proposal = propose_layout(Content{"t", text});
  EXPECT_EQ(proposal.layout["fill"], Json::array({"n/a", 9999.0}));
  EXPECT_EQ(read_samples(Content{"t", text}, {.layout = to_line(proposal.layout)}).rows(), 1u);
}

TEST(Proposal, FillValuesAreProposedAsGuesses) {
  const std::string text =
      "theta_i,phi_i,theta_o,phi_o,fr\n30,0,20,180,.5\n30,0,40,180,-999\n30,0,50,180,9.96921e36\n"
      "30,0,55,180,-9999\n30,0,60,180,.2\n";
  const TableProposal proposal = propose_layout(Content{"t", text});
  EXPECT_EQ(proposal.layout["fill"], Json::array({-9999.0, -999.0, 9.96921e36}));
  EXPECT_THAT(to_line(proposal.layout["unsure"]), HasSubstr("$.fill"));
  EXPECT_EQ(read_samples(Content{"t", text}, {.layout = to_line(proposal.layout)}).rows(), 2u);
  // Noise and a single large value are no fill values.
  EXPECT_FALSE(
      propose_layout(Content{"t", "theta_i,phi_i,theta_o,phi_o,fr\n30,0,20,180,-998\n30,0,40,180,999\n"})
          .layout.contains("fill"));
}

TEST(Proposal, OtherFormatsAreRefusedByName) {
  const auto refused = [](const std::string& text) {
    return message_of([&] { propose_layout(Content{"x", text}); });
  };
  EXPECT_THAT(refused(kAstm),
              HasSubstr("x: is in the format astm, and a layout describes only tables of columns of text"));
  EXPECT_THAT(refused("{\"a\": 1}"), HasSubstr("is in the format json"));
  EXPECT_THAT(refused("theta_o \\ theta_i,20,40\n-30,.1,.2\n30,.3,.4\n"),
              HasSubstr("is a matrix of two angles"));
  EXPECT_NE(refused("only words\nand more of them\n"), "accepted");
}

}  // namespace
}  // namespace brdf::io
