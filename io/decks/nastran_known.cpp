#include "io/decks/nastran_known.hpp"

#include <algorithm>

namespace plica {
namespace {

const std::set<std::string> followed{
    "DMIG",    "GRID",    "GRDSET", "SPOINT", "CORD1R",  "CORD1C",  "CORD1S", "CORD2R", "CORD2C",
    "CORD2S",  "MAT1",    "MAT2",   "MAT8",   "PSHELL",  "PCOMP",   "PCOMPG", "CQUAD4", "CQUADR",
    "CTRIA3",  "CTRIAR",  "CQUAD8", "CTRIA6", "CQUAD2",  "CTRIA2",  "CQUAD1", "CTRIA1", "PQUAD1",
    "PTRIA1",  "PQUAD2",  "PTRIA2", "CQDMEM", "CQDMEM1", "CQDMEM2", "CTRMEM", "PQDMEM", "PQDMEM1",
    "PQDMEM2", "PTRMEM",  "CSHEAR", "PSHEAR", "PBAR",    "PBARL",   "PBEAM",  "PBEAML", "CBAR",
    "CBEAM",   "BAROR",   "BEAMOR", "PROD",   "CROD",    "CONROD",  "PTUBE",  "CTUBE",  "CONM1",
    "CONM2",   "PMASS",   "CMASS1", "CMASS2", "CMASS3",  "CMASS4",  "PBUSH",  "CBUSH",  "PELAS",
    "CELAS1",  "CELAS2",  "CELAS3", "CELAS4", "RBE2",    "RBE3",    "RBAR",   "CRIGD1", "CRIGD2",
    "CBUSH1D", "PBUSH1D", "MPC",    "MPCADD", "SPC",     "SPC1",    "SPCADD", "PARAM",  "SEBULK",
    "SECONCT", "EXTRN",   "GENEL",  "RBE1",   "CRIGD3",  "RROD",    "CRIGDR"};

// Beginnings of names are enough where all cards that begin so are passed over.
const std::set<std::string> passed_over{
    // loads and temperatures
    "FORCE", "FORCE1", "FORCE2", "MOMENT", "MOMENT1", "MOMENT2", "LOAD", "GRAV", "RFORCE", "ACCEL",
    "ACCEL1", "PLOAD", "PLOAD1", "PLOAD2", "PLOAD4", "PLOADX1", "PLOADB3", "SLOAD", "LSEQ", "DAREA",
    "DELAY", "DPHASE", "TEMP", "TEMPD", "TEMPP1", "TEMPP2", "TEMPP3", "TEMPRB", "TEMPBC", "TEMPN1",
    "DEFORM", "DLOAD", "RLOAD1", "RLOAD2", "TLOAD1", "TLOAD2", "SPCD", "SPCR", "SPCADDX", "CLOAD",
    "QHBDY", "QVOL", "QBDY1", "QBDY2", "QBDY3", "CONV", "PCONV", "VIEW", "VIEW3D", "RADM", "RADBC",
    "RADSET", "CHBDYE", "CHBDYG", "CHBDYP", "PHBDY", "LOADCYN", "LOADCYH", "LOADT", "FORCDST",
    // what to compute
    "EIGR", "EIGRL", "EIGB", "EIGC", "EIGP", "FREQ", "FREQ1", "FREQ2", "FREQ3", "FREQ4", "FREQ5",
    "TSTEP", "TSTEP1", "EPOINT", "PLFACT", "NOLIN1", "NOLIN2", "NOLIN3", "NOLIN4", "TSTEPNL", "TIC",
    "TF", "NLPARM", "NLPCI", "NLCNTL", "NLSTEP", "NLADAPT", "RANDPS", "RANDT1", "RCROSS", "ASET",
    "ASET1", "OMIT", "OMIT1", "BSET", "BSET1", "CSET", "CSET1", "QSET", "QSET1", "USET", "USET1",
    "SUPORT", "SUPORT1", "SUPAX", "SEQGP", "MDLPRM", "DYNRED", "ITER", "DTI", "DMI", "DMIJ",
    "DMIJI", "DMIK", "TABLEST", "SNORM", "MODTRAK", "CSUPER", "RVDOF", "RVDOF1", "CMREL", "BNDFREE",
    "BNDFIX", "BNDFIX1", "BNDFREE1", "CYSUP",
    // tables, damping, temperature and plasticity of materials
    "TABLED1", "TABLED2", "TABLED3", "TABLED4", "TABLEM1", "TABLEM2", "TABLEM3", "TABLEM4",
    "TABLES1", "TABRND1", "TABRNDG", "TABDMP1", "TABLEH1", "TABLEG", "TABL3D", "CDAMP1", "CDAMP2",
    "CDAMP3", "CDAMP4", "CDAMP5", "PDAMP", "PDAMP5", "PDAMPT", "CVISC", "PVISC", "PBUSHT", "PELAST",
    "MATT1", "MATT2", "MATT8", "MATS1", "MATEP", "MATF", "MATF1", "MATTF", "MATPF", "MAT4", "MAT5",
    "MATT4", "MATT5", "MATVP", "CREEP", "STRENGTH", "MATFTG", "PFTG", "FTGDEF", "FTGPARM",
    // pictures, sets, listings
    "PLOTEL", "PLOTEL3", "PLOTEL4", "SET1", "SET2", "SET3", "SET4", "SESET", "GRIDB", "ECHOON",
    "ECHOOFF", "SWLDPRM", "PARVAR", "PARTVEC", "USET2", "DEBUG", "YPARAM", "BARRIER", "OUTPUT",
    "SURF", "ELIST", "CNGRNT", "SPCOFF", "SPCOFF1", "DEACTEL", "OUTRCV", "PARAMARM", "ENDDATA",
    "INIT", "VECTOR", "UNGLUE", "CSCALE", "MONPNT1", "MONPNT2", "MONPNT3", "MONDSP1", "MONSUM",
    "MONCNCM", "NSMLX", "SYSNOISE", "FEFREQ", "ENFMOTN", "NLCNTLG",
    // optimisation
    "DESVAR", "PLIMIT", "POPT", "DLINK", "DEQATN", "DRESP1", "DRESP2", "DRESP3", "DCONSTR",
    "DCONADD", "DVPREL1", "DVPREL2", "DVMREL1", "DVMREL2", "DVCREL1", "DVCREL2", "DVGRID",
    "DVBSHAP", "DVSHAP", "DVSET", "DOPTPRM", "DSCREEN", "DTABLE", "DDVAL", "DTABLE2", "DVGEOM",
    "TOPVAR", "DTPL", "DSIZE", "DSHUFFL", "BMFACE", "DVSHAP1", "DCONADDX", "TOMVAR", "BEADVAR",
    "DSELECT"};

// Beginnings of names of cards of aeroelasticity.
const std::vector<std::string> aero{
    "AE",     "CAERO",   "PAERO",   "SPLINE",  "MKAERO",  "FLUTTER", "FLFACT",  "TRIM",
    "DIVERG", "GUST",    "CSSCHD",  "UXVEC",   "CAER",    "PANLST",  "PAFOIL",  "MLD",
    "ASE",    "CONCT",   "BODY7",   "SEGMESH", "BLKWAKE", "BLKLAY",  "SURFSET", "ATTACH",
    "FLTFST", "PLTAERO", "PLTMODE", "PLTFLUT", "PLTSURF", "PLTTRIM", "PLTTIME", "PLTVG",
    "PLTCP",  "TRIMFLT", "TRIMVAR", "ACOORD",  "RAERO",   "LOADMOD", "BBODY",   "STFLOW",
    "BLKSEQ", "GENGAF",  "CELLWNG", "CELLBOX"};

const std::set<std::string> solids{
    "CHEXA",   "CHEXA20", "CHEXA1",  "CHEXA2",  "CHEX8",   "CHEX20",  "CTETRA",  "CPENTA",
    "CPYRAM",  "CPYRA",   "CWEDGE",  "CIHEX1",  "CIHEX2",  "CIHEX3",  "PIHEX",   "PSOLID",
    "PLSOLID", "PCOMPS",  "CTRIAX",  "CTRIAX6", "CQUADX",  "CQUADX4", "CQUADX8", "CTRAX3",
    "CTRAX6",  "CTRAPRG", "CTRIARG", "CPLSTN3", "CPLSTN4", "CPLSTN6", "CPLSTN8", "CPLSTS3",
    "CPLSTS4", "CPLSTS6", "CPLSTS8", "PPLANE",  "CTRAPAX", "CTRIAAX", "PTRAPAX", "PTRIAAX",
    "CIS2D8",  "PIS2D8",  "PLPLANE", "CHACAB",  "CHACBR"};

// Names that do not begin as elements or rigid elements do, or that would be taken for such.
const std::set<std::string> not_had{
    "RSPLINE", "RSSCON",  "RTRPLT",  "RTRPLT1",  "RJOINT",   "RBAR1",    "CRBE1",   "CRBE3",
    "CRROD",   "CRBAR",   "CRTRPLT", "CRSPLINE", "CYJOIN",   "CYAX",     "CYSYM",   "BCTABLE",
    "BCTADD",  "BCTSET",  "BGSET",   "BGADD",    "BCONP",    "BCONTACT", "BCBODY",  "BLSEG",
    "BFRIC",   "BSURF",   "BSURFS",  "BCPROP",   "BCPARA",   "BGPARM",   "BCTPARM", "BCTPARA",
    "BCRPARA", "BCSCAP",  "BOLT",    "BOLTFOR",  "NSM",      "NSM1",     "NSML",    "NSML1",
    "NSMADD",  "ADUM1",   "GRIDF",   "GRIDS",    "AXIC",     "AXIF",     "AXSLOT",  "RINGAX",
    "RINGFL",  "SECTAX",  "POINTAX", "FSLIST",   "ACMODL",   "GRIDA",    "SEELT",   "SEEXCLD",
    "SELOC",   "SEMPLN",  "SETREE",  "SEBSET",   "SECSET",   "SEQSET",   "SEUSET",  "SENQSET",
    "SELOAD",  "SELABEL", "RELEASE", "CGEN",     "BEGIN",    "CONTACT",  "TIE",     "MAT3",
    "MAT9",    "MAT10",   "MAT11",   "MATHE",    "MATHP",    "MATG",     "MATORT",  "ROTOR",
    "ROTORG",  "ROTORD",  "RSPINR",  "UNBALNC",  "BEAMSECT", "PBMSECT",  "PBRSECT", "PBCOMP",
    "PBEAM3",  "PBEND",   "PGAP",    "PWELD",    "PFAST",    "PSEAM",    "PBUSH2D", "PCONEAX",
    "PSHEARN", "PRAC2D",  "PRAC3D",  "PTRBSC",   "PQDPLT",   "PTRPLT",   "PTWIST",  "PTRSHL",
    "PTRIM6",  "PTRPLT1", "PTORDRG", "PFLUID",   "MFLUID",   "ELIST1",   "PACABS",  "PACBAR",
    "PHBDYX",  "MATDIGI"};

bool begins_as(const std::string& name, const std::vector<std::string>& beginnings) {
  return std::any_of(beginnings.begin(), beginnings.end(),
                     [&](const std::string& b) { return name.starts_with(b); });
}

} // namespace

const std::set<std::string>& followed_cards() {
  return followed;
}

CardKind kind_of(const std::string& card) {
  if (followed.contains(card)) return CardKind::followed;
  if (passed_over.contains(card) || begins_as(card, aero)) return CardKind::passed;
  if (solids.contains(card)) return CardKind::solid;
  return not_had.contains(card) || is_element(card) ? CardKind::structural : CardKind::unknown;
}

bool is_element(const std::string& card) {
  static const std::vector<std::string> beginnings{
      "CQUAD",  "CTRI",   "CBAR",   "CBEAM",   "CROD",    "CONROD",  "CTUBE",   "CONM",   "CMASS",
      "CELAS",  "CBUSH",  "CSHEAR", "CBEND",   "CGAP",    "CWELD",   "CFAST",   "CSEAM",  "CQDPLT",
      "CTRPLT", "CTRBSC", "CQDMEM", "CTRMEM",  "CTWIST",  "CTORDRG", "CCONEAX", "CFLUID", "CRAC",
      "CDUM",   "CHEX",   "CTETRA", "CPENTA",  "CPYRA",   "CIHEX",   "CWEDGE",  "CPLST",  "CTRAP",
      "CIS2D8", "CTRSHL", "CFHEX",  "CFTETRA", "CFWEDGE", "CAXIF",   "CSLOT",   "CHAC",   "CTRIM6",
      "CTRAX",  "CINTC",  "CAABSF", "CCRSFIL"};
  return begins_as(card, beginnings) || card == "RBE2" || card == "RBE3" || card == "RBAR" ||
         card == "RBE1" || card == "CRIGD1" || card == "CRIGD2" || card == "CRIGD3" ||
         card == "RROD" || card == "CRIGDR" || card == "GENEL";
}

bool is_analysis_set(const std::string& card) {
  static const std::set<std::string> all{"ASET", "ASET1", "BSET", "BSET1",
                                         "CSET", "CSET1", "QSET", "QSET1"};
  return all.contains(card);
}

bool is_structural_parameter(const std::string& name) {
  static const std::set<std::string> all{"CK1", "CK2",   "CK3",   "CM1",
                                         "CM2", "MFACT", "K42GG", "WTMASSX"};
  return all.contains(name);
}

std::string group_of_numbers(const std::string& card) {
  static const std::map<std::string, std::string> groups{
      {"PSHELL", "shell"},  {"PCOMP", "shell"},   {"PCOMPG", "shell"},   {"PBUSH", "PBUSH"},
      {"CORD2R", "CORD"},   {"CORD2C", "CORD"},   {"CORD2S", "CORD"},    {"CORD1R", "CORD"},
      {"CORD1C", "CORD"},   {"CORD1S", "CORD"},   {"PBAR", "beam"},      {"PBARL", "beam"},
      {"PBEAM", "beam"},    {"PBEAML", "beam"},   {"PROD", "PROD"},      {"PTUBE", "PTUBE"},
      {"PSHEAR", "PSHEAR"}, {"PQUAD2", "PQUAD2"}, {"PQDMEM", "PQDMEM"},  {"PTRIA2", "PTRIA2"},
      {"PQUAD1", "PQUAD1"}, {"PTRIA1", "PTRIA1"}, {"PBUSH1D", "PBUSH1D"}};
  const auto group = groups.find(card);
  if (group != groups.end()) return group->second;
  const bool sides = card == "CORD1R" || card == "CORD1C" || card == "CORD1S";
  return !sides && is_element(card) ? card : "";
}

std::size_t longest_card(const std::string& card) {
  static const std::map<std::string, std::size_t> longest{
      {"GRID", 8},    {"CORD2R", 16}, {"CORD2C", 16}, {"CORD2S", 16}, {"MAT1", 16},
      {"PSHELL", 16}, {"CQUAD4", 16}, {"CQUADR", 16}, {"CTRIA3", 16}, {"CTRIAR", 16},
      {"PBAR", 24},   {"CBAR", 16},   {"CBEAM", 24},  {"CONM2", 16},  {"CBUSH", 16},
      {"PELAS", 8},   {"CELAS1", 8},  {"CELAS2", 8},  {"CELAS3", 8},  {"CELAS4", 8},
      {"CMASS1", 8},  {"CMASS2", 8},  {"CMASS3", 8},  {"CMASS4", 8},  {"CROD", 8},
      {"CONROD", 16}, {"CTUBE", 8},   {"PROD", 8},    {"PTUBE", 8},   {"RBAR", 16},
      {"PARAM", 8},   {"SPC", 8},     {"CSHEAR", 8},  {"PSHEAR", 8},  {"CQUAD8", 24},
      {"CTRIA6", 24}, {"CONM1", 24},  {"GRDSET", 8},  {"BAROR", 8},   {"BEAMOR", 8}};
  const auto found = longest.find(card);
  return found == longest.end() ? 0 : found->second;
}

} // namespace plica
