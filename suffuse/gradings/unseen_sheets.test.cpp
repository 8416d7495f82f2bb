// Sheets in the style of American forms, summaries and exports, written with their curves worked out by hand before
// the reader's source was opened.

#include "suffuse/gradings/sheets_for_tests.hpp"

#include <gtest/gtest.h>

namespace suffuse::gradings {
namespace {

using namespace testing;

TEST(UnseenSheets, AmericanFormsGiveTheirCurves) {
    expect_sheets({
        {"astm-d6913.csv",
         "Particle-Size Distribution (Gradation) of Soils Using Sieve Analysis,,,\n"
         "ASTM D6913/D6913M-17 Method A,,,\n"
         "Project:,Mill Creek Dam,Job No.,19-0442\n"
         "Boring / Sample:,B-12 / S-4,Depth (ft):,22.5 - 24.0\n"
         "Tested By:,JRM,Date:,3/14/2019\n"
         "Dry Mass of Specimen (g):,1000.0,,\n"
         ",,,\n"
         "Sieve Designation,Sieve Opening (mm),Cumulative Mass Retained (g),Percent Passing (%)\n"
         "3/4 in.,19.0,0.0,100\n"
         "3/8 in.,9.5,52.0,95\n"
         "No. 4,4.75,118.0,88\n"
         "No. 10,2.00,241.0,76\n"
         "No. 20,0.850,395.0,61\n"
         "No. 40,0.425,571.0,43\n"
         "No. 60,0.250,698.0,30\n"
         "No. 100,0.150,802.0,20\n"
         "No. 140,0.106,851.0,15\n"
         "No. 200,0.075,887.0,11\n"
         ",,,\n"
         "Remarks:,Sample washed over No. 200,,\n",
         {{"",
           {{0.075, 11},
            {0.106, 15},
            {0.15, 20},
            {0.25, 30},
            {0.425, 43},
            {0.85, 61},
            {2, 76},
            {4.75, 88},
            {9.5, 95},
            {19, 100}}}},
         "skipped 6 title lines; the column headings are on line 8"},
        {"usace-sieve-blocks.csv",
         "GRADATION CURVES,,\n"
         "Project: Lock and Dam 9,,\n"
         ",,\n"
         "U.S. STANDARD SIEVE OPENING IN INCHES,,PERCENT FINER BY WEIGHT\n"
         "3,,100.0\n"
         "1 1/2,,92.4\n"
         "3/4,,81.0\n"
         "3/8,,70.3\n"
         "U.S. STANDARD SIEVE NUMBERS,,PERCENT FINER BY WEIGHT\n"
         "4,,61.2\n"
         "10,,50.7\n"
         "20,,41.9\n"
         "40,,33.0\n"
         "70,,24.6\n"
         "100,,19.8\n"
         "200,,12.1\n"
         "HYDROMETER (mm),,PERCENT FINER BY WEIGHT\n"
         "0.0412,,9.4\n"
         "0.0173,,6.2\n"
         "0.0055,,3.1\n",
         {{"",
           {{0.0055, 3.1},
            {0.0173, 6.2},
            {0.0412, 9.4},
            {0.075, 12.1},
            {0.15, 19.8},
            {0.212, 24.6},
            {0.425, 33},
            {0.85, 41.9},
            {2, 50.7},
            {4.75, 61.2},
            {9.5, 70.3},
            {19, 81},
            {37.5, 92.4},
            {75, 100}}}},
         "a second table begins here and goes on with the curve above"},
        {"us-report-spec-column.csv",
         "Particle Size Distribution Report,,,\n"
         "% +3\",% Gravel,% Sand,% Fines\n"
         "0.0,28.0,60.0,12.0\n"
         ",,,\n"
         "SIEVE,PERCENT,SPEC.*,PASS?\n"
         "SIZE,FINER,PERCENT,(X=NO)\n"
         "1.5\",100.0,,\n"
         "3/4\",94.0,,\n"
         "3/8\",84.0,,\n"
         "#4,72.0,,\n"
         "#10,60.0,,\n"
         "#20,46.0,,\n"
         "#40,32.0,,\n"
         "#60,24.0,,\n"
         "#100,18.0,,\n"
         "#200,12.0,,\n"
         ",,,\n"
         "D90= 14.3,D85= 10.1,D60= 2.00,\n"
         "D50= 1.09,D30= 0.371,D15= 0.106,\n"
         "D10=,Cu=,Cc=,\n"
         "USCS= SM,AASHTO= A-1-b,,\n"
         "* (no specification provided),,,\n",
         {{"",
           {{0.075, 12},
            {0.15, 18},
            {0.25, 24},
            {0.425, 32},
            {0.85, 46},
            {2, 60},
            {4.75, 72},
            {9.5, 84},
            {19, 94},
            {37.5, 100}}}},
         "passed over as results, which are no sieves: `D90`"},
        {"across-sieve-numbers-summary.csv",
         "SUMMARY OF LABORATORY RESULTS,,,,,,,,,,,\n"
         ",,,,Percent Passing Sieve,,,,,,,\n"
         "Boring,Sample,Depth (ft),USCS,3/4\",3/8\",#4,#10,#40,#100,#200,LL\n"
         "B-1,S-2,5.0,SM,100,97,92,85,60,33,18.4,NP\n"
         "B-1,S-5,20.0,SP-SM,,100,98,94,71,22,7.9,NP\n"
         "B-3,S-1,2.5,GM,88,74,61,50,34,22,15.0,24\n",
         {{"B-1 S-2 5.0", {{0.075, 18.4}, {0.15, 33}, {0.425, 60}, {2, 85}, {4.75, 92}, {9.5, 97}, {19, 100}}},
          {"B-1 S-5 20.0", {{0.075, 7.9}, {0.15, 22}, {0.425, 71}, {2, 94}, {4.75, 98}, {9.5, 100}}},
          {"B-3 S-1 2.5", {{0.075, 15}, {0.15, 22}, {0.425, 34}, {2, 50}, {4.75, 61}, {9.5, 74}, {19, 88}}}},
         "the sieves stand across, and a line is a sample: 7 sieves, 3 samples; not read: `USCS`, `LL`"},
        {"gint-long.csv",
         "\"PointID\",\"Depth\",\"Reading_No\",\"Sieve_Size\",\"Percent_Passing\"\n"
         "\"\",\"m\",\"\",\"mm\",\"%\"\n"
         "\"BH-01\",3.5,1,19,100\n"
         "\"BH-01\",3.5,2,4.75,82\n"
         "\"BH-01\",3.5,3,2,70\n"
         "\"BH-01\",3.5,4,0.425,41\n"
         "\"BH-01\",3.5,5,0.075,13\n"
         "\"BH-01\",7.0,1,9.5,100\n"
         "\"BH-01\",7.0,2,4.75,95\n"
         "\"BH-01\",7.0,3,2,88\n"
         "\"BH-01\",7.0,4,0.425,52\n"
         "\"BH-01\",7.0,5,0.075,6\n"
         "\"BH-02\",3.5,1,4.75,100\n"
         "\"BH-02\",3.5,2,2,99\n"
         "\"BH-02\",3.5,3,0.425,80\n"
         "\"BH-02\",3.5,4,0.075,31\n",
         {{"BH-01 3.5", {{0.075, 13}, {0.425, 41}, {2, 70}, {4.75, 82}, {19, 100}}},
          {"BH-01 7.0", {{0.075, 6}, {0.425, 52}, {2, 88}, {4.75, 95}, {9.5, 100}}},
          {"BH-02 3.5", {{0.075, 31}, {0.425, 80}, {2, 99}, {4.75, 100}}}},
         "not read: `Reading_No`"},
        {"hydrometer-d7928.csv",
         "Hydrometer analysis ASTM D7928,,,,,\n"
         "Hydrometer type:,152H,Gs:,2.68,Dispersant:,NaHMP\n"
         "Dry mass of soil (g):,50.0,,,,\n"
         "Elapsed time (min),Temperature (\260C),Hydrometer reading Rh,Effective depth L (cm),Diameter D (mm),Percent "
         "finer N (%)\n"
         "1,21.5,48,8.4,0.0392,84.2\n"
         "2,21.5,44,9.1,0.0288,76.3\n"
         "4,21.5,40,9.7,0.0211,68.4\n"
         "15,21.5,33,10.9,0.0115,54.6\n"
         "30,21.0,29,11.5,0.0084,46.5\n"
         "60,21.0,25,12.2,0.0061,38.6\n"
         "240,20.5,19,13.2,0.0032,26.5\n"
         "1440,20.0,13,14.2,0.0014,14.4\n",
         {{"",
           {{0.0014, 14.4},
            {0.0032, 26.5},
            {0.0061, 38.6},
            {0.0084, 46.5},
            {0.0115, 54.6},
            {0.0211, 68.4},
            {0.0288, 76.3},
            {0.0392, 84.2}}}},
         "not read: `Elapsed time (min)`, `Temperature (\302\260C)`, `Hydrometer reading Rh`, `Effective depth L "
         "(cm)`"},
        {"tare-and-wash.csv",
         "Sieve,Sieve opening,Mass of sieve,Mass of sieve + soil,Mass of soil retained\n"
         ",mm,g,g,g\n"
         "3/8 in,9.50,542.1,542.1,0.0\n"
         "No. 4,4.75,512.3,542.3,30.0\n"
         "No. 10,2.00,463.0,523.0,60.0\n"
         "No. 20,0.850,401.7,491.7,90.0\n"
         "No. 40,0.425,371.2,491.2,120.0\n"
         "No. 100,0.150,340.0,420.0,80.0\n"
         "No. 200,0.075,331.4,371.4,40.0\n"
         "Pan,,368.8,373.8,5.0\n"
         "Loss by washing,,,,75.0\n"
         "Total,,,,500.0\n",
         {{"", {{0.075, 16}, {0.15, 24}, {0.425, 40}, {0.85, 64}, {2, 82}, {4.75, 94}, {9.5, 100}}}},
         "`Loss by washing` is what passed the finest sieve"},
        {"cumulative-percent-retained.csv",
         "Sieve;Cum. % ret.\n"
         "1 in.;0%\n"
         "1/2 in.;7%\n"
         "No. 4;21%\n"
         "No. 8;35%\n"
         "No. 16;48%\n"
         "No. 30;63%\n"
         "No. 50;80%\n"
         "No. 100;91%\n"
         "No. 200;95.5%\n"
         "Pan;100%\n"
         "F.M.;3.45\n",
         {{"",
           {{0.075, 4.5}, {0.15, 9}, {0.3, 20}, {0.6, 37}, {1.18, 52}, {2.36, 65}, {4.75, 79}, {12.5, 93}, {25, 100}}}},
         "passed over as results, which are no sieves: `F.M.`"},
        {"three-header-rows.csv",
         ",,,,\n"
         "Sieve,,Mass,Percent,Percent\n"
         "No.,Opening,Retained,Retained,Passing\n"
         ",(mm),(g),(%),(%)\n"
         ",,,,\n"
         "1/2\",12.5,0,0,100\n"
         "#4,4.75,32,8,92\n"
         "#10,2,48,12,80\n"
         "#20,0.85,80,20,60\n"
         "#40,0.425,100,25,35\n"
         "#100,0.15,80,20,15\n"
         "#200,0.075,36,9,6\n"
         "Pan,,24,6,\n"
         ",,400,100,\n",
         {{"", {{0.075, 6}, {0.15, 15}, {0.425, 35}, {0.85, 60}, {2, 80}, {4.75, 92}, {12.5, 100}}}},
         "sizes are read from `Opening`, shares from `Percent Passing`"},
        {"specification-limits.csv",
         "Filter Zone 2A - Quality control,,,\n"
         "Sieve Size,Percent Passing,Spec. Min,Spec. Max\n"
         "3/8 in. (9.5 mm),100,100,100\n"
         "No. 4 (4.75 mm),97,95,100\n"
         "No. 8 (2.36 mm),86,80,100\n"
         "No. 16 (1.18 mm),68,50,85\n"
         "No. 30 (600 um),44,25,60\n"
         "No. 50 (300 um),21,5,30\n"
         "No. 100 (150 um),6,0,10\n"
         "No. 200 (75 um),1.8,0,3\n",
         {{"", {{0.075, 1.8}, {0.15, 6}, {0.3, 21}, {0.6, 44}, {1.18, 68}, {2.36, 86}, {4.75, 97}, {9.5, 100}}}},
         "not read: `Spec. Min`, `Spec. Max`"},
        {"total-in-metadata.csv",
         "Sample ID,EMB-7\n"
         "\"Total dry weight, g\",850\n"
         "Sieve size,Cumulative weight retained (g)\n"
         "\"3/4\"\"\",0\n"
         "\"3/8\"\"\",42.5\n"
         "#4,127.5\n"
         "#10,255\n"
         "#40,510\n"
         "#100,680\n"
         "#200,765\n",
         {{"", {{0.075, 10}, {0.15, 20}, {0.425, 40}, {2, 70}, {4.75, 85}, {9.5, 95}, {19, 100}}}},
         "shares are of the stated dry mass of 850 g: the 85 g that are not held passed the finest sieve"},
    });
}

} // namespace
} // namespace suffuse::gradings
