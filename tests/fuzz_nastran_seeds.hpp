// Nastran decks that are damaged at random, a card of nearly every kind in them.
#pragma once

#include <array>

namespace plica::test {

inline constexpr std::array nastran_seeds{
    // Coordinate systems, shells, bars of every description, rigid elements, springs, masses.
    R"(SOL 103
CEND
SPC = 1
MPC = 5
BEGIN BULK
PARAM,WTMASS,1.
GRDSET,,,,,,,456
CORD2R,1,,0.,0.,0.,0.,0.,1.,
,1.,0.,0.
CORD2C,2,1,0.,0.,0.,0.,0.,1.,
,1.,0.,0.
CORD1R,3,1,2,3
GRID,1,,0.,0.,0.,,,0
GRID,2,,1.,0.,0.,1
GRID,3,,1.,1.,0.
GRID,4,1,0.,1.,0.,,6
GRID,5,2,1.,45.,2.
GRID,6,,2.,0.,0.
GRID,7,,2.,1.,0.
GRID,8,,3.,0.,0.
GRID,9,,3.,1.,0.
=(3),*(1),,=,*(.5),==
SPOINT,101,THRU,104
CQUAD4,1,1,1,2,3,4,30.,.01
CTRIA3,2,1,2,6,3
CTRIA3,3,1,6,7,3
PSHELL,1,1,.001,1,1.2,1,.8,.5
MAT1,1,2.+11,,.3,7800.
CBAR,11,2,1,2,0.,0.,1.
,5
CBAR,12,3,2,3,5
PBAR,2,1,1.-3,1.-8,2.-8,3.-8,.1
PBARL,3,1,,TUBE
,.02,.01
CBEAM,13,4,3,4,0.,0.,1.
PBEAM,4,1,1.-3,1.-8,2.-8,,3.-8
CROD,14,5,4,5
PROD,5,1,1.-3,1.-8
CONROD,15,5,6,1,1.-3
CBUSH,16,6,6,7,,,,0
PBUSH,6,K,1.+5,1.+5,1.+5,1.+3,1.+3,1.+3
CELAS1,17,7,6,1,7,1
PELAS,7,1.+4
CELAS2,18,1.+4,101,,102
CONM2,21,7,,2.5,.1,0.,0.
,1.-2,,1.-2,,,1.-2
CMASS2,22,3.,103
CMASS4,23,2.,104
RBE2,31,8,123456,9,10
RBE3,32,,11,123,1.,123,1,2
,3,1.,123456,4
,UM,11,12,3,3
CRIGD2,34,8,12,123456
CQUAD1,5,8,2,6,7,3
PQUAD1,8,1,.001,1,1.-10,1,.001
CBUSH1D,19,19,6,7
PBUSH1D,19,1.+4,2.
RBAR,33,5,6,123456,,,123456
MPC,5,7,1,1.,8,1,-1.
MPCADD,6,5
SPC1,1,123456,1,THRU,2
SPC,1,4,3,0.
SPCADD,2,1
ENDDATA
)",
    // Plies, shells with middle nodes, shear panels, matrices, loads of two subcases.
    R"(SOL 101
CEND
K2GG = 2.*KX, KY
SPC = 1
SUBCASE 1
 LOAD = 10
SUBCASE 2
 LOAD = 13
BEGIN BULK
GRID*                  1                              0.              0.
*                     0.
GRID,2,,1.,0.,0.
GRID,3,,1.,1.,0.
GRID,4,,0.,1.,0.
GRID,5,,.5,0.,0.
GRID,6,,1.,.5,0.
GRID,7,,.5,1.,0.
GRID,8,,0.,.5,0.
GRID,9,,2.,0.,0.
GRID,10,,2.,1.,0.
GRID,11,,1.5,.5,0.
GRID,12,,1.5,0.,0.
CQUAD8,1,1,1,2,3,4,5,6
,7,8
CTRIA6,2,1,2,9,3,12,11,6
CQUAD4,3,2,2,9,10,3
CSHEAR,4,3,2,9,10,3
PSHEAR,3,1,.002
MAT1,1,2.+11,,.3,7800.,1.-5
MAT2,5,4.+10,1.+10,0.,4.+10,0.,2.+10
MAT8,4,14.+10,1.+10,.3,5.+9,5.+9,3.+9,1600.
PCOMP,1,,,,,,,SYM
,4,.001,45.,,4,.001,-45.
PSHELL,2,5,.001,5
DMIG,KX,0,6,2,0
DMIG,KX,1,1,,1,1,3.
,2,1,2.,0.
DMIG,KX,2,1,,2,1,9.
DMIG    KY             0       6       2       0
DMIG*   KY                             3               1
*                      3               1         1.5D+03
FORCE,11,3,0,5.,0.,0.,1.
MOMENT,11,9,0,2.,1.,0.,0.
PLOAD4,12,1,100.
PLOAD2,12,50.,3
GRAV,13,0,9.81,0.,0.,-1.
LOAD,10,1.,2.,11,1.,12
SPC1,1,123456,1,4,8
SPC,1,2,3,.001
ENDDATA
)",
    // Profiles, tapers, walls of older decks, elements by numbers, rigid bodies of many points.
    R"(SOL 103
CEND
SPC = 1
BEGIN BULK
PARAM,COUPMASS,1
GRID,1,,0.,0.,0.
GRID,2,,1.,0.,0.
GRID,3,,1.,1.,0.
GRID,4,,0.,1.,0.
GRID,5,,0.,0.,1.
GRID,6,,1.,0.,1.
GRID,7,,1.,1.2,1.
GRID,8,,0.,.9,1.
GRID,9,,2.,0.,0.
GRID,10,,2.,1.,0.
GRID,11,,2.,0.,1.
GRID,12,,2.,1.,1.
GRID,13,,3.,0.,0.
GRID,14,,3.,1.,0.
SPOINT,101,THRU,103
MAT1,1,2.+11,,.3,7800.
MAT8,4,14.+10,1.+10,.3,5.+9,5.+9,3.+9,1600.
CBEAM,1,1,1,2,0.,1.,0.,,+A
+A,,,0.,.01,0.,0.,.01,0.
PBEAML,1,1,,T
,.04,.06,.004,.004,.1,YES,.5,.05
,.06,.004,.004,.1,NO,1.,.06,.06
,.005,.005,.2
CBEAM,8,8,10,12,1.,0.,0.
PBEAML,8,1,,L
,.04,.06,.004,.005
CBEAM,2,2,2,3,0.,0.,1.
PBEAM,2,1,2.-3,2.-6,3.-6,,4.-6,.3
,.01,.02,,,,,,
,YES,1.,3.-3,3.-6,4.-6,,5.-6,.3
,.01,.02
,1.,.8,,,.01,.01
,.02,.01,.02,.01,.01,.0,.01
CBAR,3,3,3,4,0.,0.,1.
PBARL,3,1,,HAT
,.04,.003,.03,.01
CBAR,4,4,4,1,0.,0.,1.
PBARL,4,1,,DBOX
,.08,.04,.04,.002,.003,.002,.004,.003
,.002,.002
CBAR,5,5,5,6,0.,1.,0.,,+B
+B,,45
PBARL,5,1,,HEXA
,.01,.05,.03
CBAR,6,6,1,5,1.,0.,0.
PBARL,6,1,,CHAN2
,.003,.004,.04,.05
CBAR,7,7,2,6,1.,0.,0.
PBARL,7,1,,HAT1
,.06,.04,.02,.003,.002
CSHEAR,11,11,5,6,7,8
PSHEAR,11,1,.002,.5,,1.2,.3
CQUAD4,12,12,2,9,10,3,30.,.01
PCOMP,12,,.2,,,,,SYM
,4,.001,0.,,4,.001,90.
CQUADR,13,13,1,2,3,4
PSHELL,13,1,.002,1,,1,,.5
CTRIAR,14,13,5,6,7
CQDMEM,15,15,2,6,7,3
PQDMEM,15,1,.001,.1
CTUBE,16,16,6,7
PTUBE,16,1,.03,.002
GENEL,21,,9,1,9,2,9,3
,UD,,13,1,13,2,13,3
,K,1.+5,2.+3,1.+3,2.+5,1.+3,3.+5
,S,1.,0.,0.,0.,1.,0.
,0.,0.,1.
GENEL,22,,101,0,102,0
,Z,1.-4,1.-6,2.-4
CMASS4,23,2.,101
CMASS3,24,24,102,103
PMASS,24,1.5
CELAS4,25,1.+4,102,103
CONM1,26,7,,2.,,2.
,2.,,,,1.-2
,,1.-2,,,,,,1.-2
CONM2,27,12,,2.,.1,0.,.1
,1.-2,,1.-2,,,1.-2
RBE1,31,9,123456
,UM,11,123456,12,123456
CRIGD3,32,13,123456
,MSET,14,123456
RROD,33,6,8,1
CRIGDR,34,7,8,2
SPC1,1,123456,1,4,5
ENDDATA
)"};

} // namespace plica::test
