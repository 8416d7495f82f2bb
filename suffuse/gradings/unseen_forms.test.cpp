// Sheets in the style of European forms, consultants' tables and a laser, written with their curves worked out by hand
// before the reader's source was opened.

#include "suffuse/gradings/sheets_for_tests.hpp"

#include <gtest/gtest.h>

namespace suffuse::gradings {
namespace {

using namespace testing;

TEST(UnseenSheets, EuropeanFormsGiveTheirCurves) {
    expect_sheets({
        {"bs1377-sieving-beside-sedimentation.csv",
         "PARTICLE SIZE DISTRIBUTION,,,\n"
         "BS1377:Part 2:1990 Clause 9.2 and 9.5,,,\n"
         "Borehole No.,BH104,Sample Depth (m),4.50\n"
         ",,,\n"
         "Sieving,,Sedimentation,\n"
         "Particle Size mm,% Passing,Particle Size mm,% Passing\n"
         "37.5,100,0.0630,28\n"
         "28,97,0.0461,25\n"
         "20,93,0.0330,22\n"
         "14,89,0.0235,19\n"
         "10,85,0.0122,15\n"
         "6.3,79,0.0063,11\n"
         "5,76,0.0032,8\n"
         "3.35,71,0.0014,5\n"
         "2,64,,\n"
         "1.18,57,,\n"
         "0.6,48,,\n"
         "0.425,44,,\n"
         "0.3,40,,\n"
         "0.212,36,,\n"
         "0.15,33,,\n"
         "0.063,28,,\n"
         ",,,\n"
         "Sample Proportions,% dry mass,,\n"
         "Cobbles,0,,\n"
         "Gravel,36,,\n"
         "Sand,36,,\n"
         "Silt,22,,\n"
         "Clay,6,,\n"
         ",,,\n"
         "Grading Analysis,,,\n"
         "D100,mm,37.5,\n"
         "D60,mm,1.48,\n"
         "D30,mm,0.0877,\n"
         "D10,mm,0.00496,\n"
         "Uniformity Coefficient,,300,\n"
         "Curvature Coefficient,,1.1,\n",
         {{"",
           {{0.0014, 5}, {0.0032, 8}, {0.0063, 11}, {0.0122, 15}, {0.0235, 19}, {0.033, 22}, {0.0461, 25}, {0.063, 28},
            {0.15, 33},  {0.212, 36}, {0.3, 40},    {0.425, 44},  {0.6, 48},    {1.18, 57},  {2, 64},      {3.35, 71},
            {5, 76},     {6.3, 79},   {10, 85},     {14, 89},     {20, 93},     {28, 97},    {37.5, 100}}}},
         "passed over as results, which are no sieves: `Cobbles`, `Gravel`"},
        {"nf-p94-056.csv",
         "Laboratoire r\351gional - Analyse granulom\351trique par tamisage;;;\n"
         "Norme NF P 94-056;;;\n"
         "Dossier n\260;2021-118;Sondage;SC3\n"
         "Profondeur (m);2,50 \340 3,00;Date;12/04/2021\n"
         "Masse s\350che totale (g);1600,0;;\n"
         ";;;\n"
         "Ouverture tamis (mm);Refus cumul\351s (g);Refus cumul\351s (%);Tamisats cumul\351s (%)\n"
         "20;0,0;0,0;100,0\n"
         "16;48,0;3,0;97,0\n"
         "10;160,0;10,0;90,0\n"
         "5;320,0;20,0;80,0\n"
         "2;560,0;35,0;65,0\n"
         "1;800,0;50,0;50,0\n"
         "0,5;1040,0;65,0;35,0\n"
         "0,2;1248,0;78,0;22,0\n"
         "0,1;1376,0;86,0;14,0\n"
         "0,08;1440,0;90,0;10,0\n"
         ";;;\n"
         "Passant \340 80 \265m;;;10,0 %\n"
         "Dmax (mm);20;;\n"
         "Op\351rateur : H\351l\350ne;;;\n",
         {{"",
           {{0.08, 10}, {0.1, 14}, {0.2, 22}, {0.5, 35}, {1, 50}, {2, 65}, {5, 80}, {10, 90}, {16, 97}, {20, 100}}}},
         "passed over as results, which are no sieves: `Passant \303\240 80 \302\265m`, `Dmax (mm)`"},
        {"din-18123.txt",
         "K\366rnungslinie nach DIN 18123\r\n"
         "Entnahmestelle:\tSchurf 7\r\n"
         "Tiefe:\t1,80 m\r\n"
         "\r\n"
         "Maschenweite\tR\374ckstand\tR\374ckstand\tSiebdurchgang\r\n"
         "[mm]\t[g]\t[%]\t[%]\r\n"
         "16\t0,0\t0,0\t100,0\r\n"
         "8\t25,0\t5,0\t95,0\r\n"
         "4\t50,0\t10,0\t85,0\r\n"
         "2\t75,0\t15,0\t70,0\r\n"
         "1\t100,0\t20,0\t50,0\r\n"
         "0,25\t150,0\t30,0\t20,0\r\n"
         "0,063\t60,0\t12,0\t8,0\r\n"
         "Schale\t40,0\t8,0\t-\r\n"
         "Summe\t500,0\t100,0\t\r\n"
         "\r\n"
         "Siebverlust:\t0,0 %\r\n"
         "Ungleichf\366rmigkeitszahl U\t17,4\r\n"
         "Kr\374mmungszahl C\t0,9\r\n",
         {{"", {{0.063, 8}, {0.25, 20}, {1, 50}, {2, 70}, {4, 85}, {8, 95}, {16, 100}}}},
         "`Summe` is passed over: it is no sieve"},
        {"nlt-104.csv",
         "ENSAYO DE GRANULOMETR\303\215A POR TAMIZADO (NLT-104/91);;;;\n"
         "Obra:;Presa de Valde\303\261as;Muestra:;M-3;\n"
         "Peso total muestra seca (g);2000;;;\n"
         ";;;;\n"
         "Tamices UNE (mm);Retenido parcial (g);Retenido acumulado (g);% Retenido acumulado;% Pasa\n"
         "40;0;0;0,0;100,0\n"
         "25;100;100;5,0;95,0\n"
         "20;200;300;15,0;85,0\n"
         "10;240;540;27,0;73,0\n"
         "5;300;840;42,0;58,0\n"
         "2;360;1200;60,0;40,0\n"
         "0,40;300;1500;75,0;25,0\n"
         "0,16;200;1700;85,0;15,0\n"
         "0,080;140;1840;92,0;8,0\n"
         "Fondo;160;2000;100,0;\n"
         "TOTAL;2000;;;\n",
         {{"", {{0.08, 8}, {0.16, 15}, {0.4, 25}, {2, 40}, {5, 58}, {10, 73}, {20, 85}, {25, 95}, {40, 100}}}},
         "`Fondo` is what passed the finest sieve"},
        {"across-mm.csv",
         "Sample,75 mm,37.5 mm,19 mm,9.5 mm,4.75 mm,2 mm,0.425 mm,0.075 mm\n"
         "TP1-1,100,98,91,82,70,58,31,9.5\n"
         "TP1-2,,100,96,88,77,66,40,14\n"
         "TP2-1,100,100,100,97,90,83,61,22.3\n",
         {{"TP1-1", {{0.075, 9.5}, {0.425, 31}, {2, 58}, {4.75, 70}, {9.5, 82}, {19, 91}, {37.5, 98}, {75, 100}}},
          {"TP1-2", {{0.075, 14}, {0.425, 40}, {2, 66}, {4.75, 77}, {9.5, 88}, {19, 96}, {37.5, 100}}},
          {"TP2-1", {{0.075, 22.3}, {0.425, 61}, {2, 83}, {4.75, 90}, {9.5, 97}, {19, 100}, {37.5, 100}, {75, 100}}}},
         "the sieves stand across, and a line is a sample: 8 sieves, 3 samples"},
        {"size-ranges.csv",
         "Fraction [mm],Mass [g]\n"
         "> 63,0\n"
         "63 - 31.5,120\n"
         "31.5 - 16,180\n"
         "16 - 8,240\n"
         "8 - 2,300\n"
         "2 - 0.5,180\n"
         "0.5 - 0.063,100\n"
         "< 0.063,80\n"
         "Sum,1200\n",
         {{"", {{0.063, 6.6666667}, {0.5, 15}, {2, 30}, {8, 55}, {16, 75}, {31.5, 90}, {63, 100}}}},
         "read as what lies between two sieves"},
        {"percent-signs-and-less-than.csv",
         "Date sampled: 4 May 2020\n"
         "Size (mm),Finer than\n"
         "<75,100%\n"
         "<37.5,96.5%\n"
         "<19,88%\n"
         "<9.5,77%\n"
         "<4.75,63.5%\n"
         "<2,49%\n"
         "<0.425,23%\n"
         "<0.075,8.2%\n",
         {{"", {{0.075, 8.2}, {0.425, 23}, {2, 49}, {4.75, 63.5}, {9.5, 77}, {19, 88}, {37.5, 96.5}, {75, 100}}}},
         "skipped 1 title line"},
        {"italian.csv",
         "Prova: analisi granulometrica per setacciatura (UNI CEN ISO/TS 17892-4);;;\n"
         "Cantiere;Diga di Rav\303\251dis;Campione;S2 C1\n"
         "Massa secca iniziale;600 g;;\n"
         "Apertura setaccio [mm];Trattenuto [g];Trattenuto cumulato [%];Passante [%]\n"
         "25;0;0;100\n"
         "10;60;10;90\n"
         "5;90;25;75\n"
         "2;150;50;50\n"
         "0,425;210;85;15\n"
         "0,075;60;95;5\n"
         "Fondo;30;100;0\n"
         "Totale;600;;\n",
         {{"", {{0.075, 5}, {0.425, 15}, {2, 50}, {5, 75}, {10, 90}, {25, 100}}}},
         "not read: `Trattenuto [g]`, `Trattenuto cumulato [%]`"},
        {"laser.txt",
         "Mastersizer 2000\r\n"
         "Sample Name:\tTailings slimes 4\r\n"
         "Dispersant Name:\tWater\r\n"
         "Obscuration:\t12.41 %\r\n"
         "d(0.1):\t3.1 \265m\td(0.5):\t20.0 \265m\td(0.9):\t63.2 \265m\r\n"
         "\r\n"
         "Size (\265m)\tVolume Under %\r\n"
         "1.00\t2.10\r\n"
         "2.00\t6.40\r\n"
         "5.00\t16.50\r\n"
         "10.00\t30.20\r\n"
         "20.00\t50.00\r\n"
         "40.00\t74.60\r\n"
         "63.00\t89.90\r\n"
         "100.00\t97.80\r\n"
         "150.00\t100.00\r\n",
         {{"",
           {{0.001, 2.1},
            {0.002, 6.4},
            {0.005, 16.5},
            {0.01, 30.2},
            {0.02, 50},
            {0.04, 74.6},
            {0.063, 89.9},
            {0.1, 97.8},
            {0.15, 100}}}},
         "read as Windows-1252"},
        {"stacked-samples.csv",
         "Sample: TP1 0.5 m,,\n"
         "Sieve (mm),Retained (g),Passing (%)\n"
         "10,0,100\n"
         "5,40,80\n"
         "1,60,50\n"
         "0.2,60,20\n"
         "0.063,20,10\n"
         "Pan,20,\n"
         ",,\n"
         "Sample: TP2 1.2 m,,\n"
         "Sieve (mm),Retained (g),Passing (%)\n"
         "5,0,100\n"
         "1,30,90\n"
         "0.2,120,50\n"
         "0.063,105,15\n"
         "Pan,45,\n",
         {{"TP1 0.5 m", {{0.063, 10}, {0.2, 20}, {1, 50}, {5, 80}, {10, 100}}},
          {"TP2 1.2 m", {{0.063, 15}, {0.2, 50}, {1, 90}, {5, 100}}}},
         "skipped 1 title line; the column headings are on line 11"},
    });
}

} // namespace
} // namespace suffuse::gradings
