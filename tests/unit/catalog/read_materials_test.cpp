#include <gtest/gtest.h>

#include "stepmill/catalog/material.h"
#include "unit/catalog/catalog_test_files.h"

namespace stepmill {
namespace {

using nlohmann::json;
using test::thrownBy;

json goodMaterials() {
    return json::parse(R"({"format": 1, "materials": [
        {"name": "brass", "also_called": ["CuZn39Pb3"], "kc11_n_per_mm2": 780, "mc": 0.18, "source": "a table"},
        {"name": "bronze", "kc11_n_per_mm2": 1780, "mc": 0.17, "source": "a test"}]})");
}

std::string refusal(const json& materials) {
    const Error error = thrownBy([&] { materialsFromText(materials.dump(), "metals.json"); });
    EXPECT_EQ(error.code(), ErrorCode::InvalidCatalog);
    return error.what();
}

TEST(ReadMaterials, GivesEveryField) {
    const MaterialFile file = materialsFromText(goodMaterials().dump(), "metals.json");
    ASSERT_EQ(file.materials.size(), 2u);
    EXPECT_EQ(file.file, "metals.json");
    const Material& brass = file.materials.front();
    EXPECT_EQ(brass.name, "brass");
    EXPECT_EQ(brass.also_called, std::vector<std::string>{"CuZn39Pb3"});
    EXPECT_DOUBLE_EQ(brass.kc11_n_per_mm2, 780);
    EXPECT_DOUBLE_EQ(brass.mc, 0.18);
    EXPECT_EQ(brass.source, "a table");
}

TEST(ReadMaterials, FindsAMaterialByEachOfItsNames) {
    const MaterialFile file = materialsFromText(goodMaterials().dump(), "metals.json");
    EXPECT_EQ(file.find("brass"), &file.materials[0]);
    EXPECT_EQ(file.find("CuZn39Pb3"), &file.materials[0]);
    EXPECT_EQ(file.find("gold"), nullptr);
}

TEST(ReadMaterials, KnowsWhatTheShopLibraryCuts) {
    const MaterialFile file = defaultMaterials();
    for (const char* name :
         {"aluminium", "aluminium 7075", "steel", "42CrMo4", "stainless 304", "cast iron", "POM"})
        EXPECT_NE(file.find(name), nullptr) << name;
}

TEST(MaterialErrors, TellAForceThatIsAbsurd) {
    json materials = goodMaterials();
    materials["materials"][1]["kc11_n_per_mm2"] = 0;
    EXPECT_EQ(refusal(materials),
              "metals.json#/materials/1/kc11_n_per_mm2: expected a number from 10 to 10000, found 0");
    materials["materials"][1]["kc11_n_per_mm2"] = 1780;
    materials["materials"][1]["mc"] = 1.5;
    EXPECT_EQ(refusal(materials), "metals.json#/materials/1/mc: expected a number from 0 to 0.8, found 1.5");
}

TEST(MaterialErrors, TellAMissingSource) {
    json materials = goodMaterials();
    materials["materials"][0].erase("source");
    EXPECT_EQ(
        refusal(materials),
        "metals.json#/materials/0: expected the field \"source\", a text of 1 to 300 characters, found none");
}

TEST(MaterialErrors, TellANameOfTwoMaterials) {
    json materials = goodMaterials();
    materials["materials"][1]["name"] = "CuZn39Pb3";
    EXPECT_EQ(refusal(materials),
              "metals.json#/materials/1/name: expected a name that no other material has, found "
              "\"CuZn39Pb3\" as in #/materials/0/also_called/0");
}

}  // namespace
}  // namespace stepmill
