#include "io/decks/abaqus_keywords.hpp"

#include <algorithm>

namespace plica {
namespace {

const std::set<std::string> passed_keywords{
    // comments, files, listings
    "HEADING", "PREPRINT", "RESTART", "OUTPUT", "NODE OUTPUT", "ELEMENT OUTPUT", "ENERGY OUTPUT",
    "CONTACT OUTPUT", "RADIATION OUTPUT", "MODAL OUTPUT", "NODE PRINT", "EL PRINT", "NODE FILE",
    "EL FILE", "ENERGY PRINT", "ENERGY FILE", "MODAL FILE", "MODAL PRINT", "CONTACT FILE",
    "CONTACT PRINT", "SECTION PRINT", "SECTION FILE", "FACE PRINT", "FILE FORMAT", "FILE OUTPUT",
    "MONITOR", "PRINT", "DIAGNOSTICS", "FILTER", "INTEGRATED OUTPUT", "INTEGRATED OUTPUT SECTION",
    "INCREMENTATION OUTPUT", "DISPLAY BODY", "TIME POINTS", "NO ANALYSIS", "DATA CHECK",
    "ELEMENT RESPONSE", "CHANGE PLOT", "DETAIL", "SIZE", "WRITE", "WAVEFRONT MINIMIZATION",
    "EXPAND", "FREQUENCY POINTS",
    // what to compute
    "STEP", "END STEP", "STATIC", "DYNAMIC", "FREQUENCY", "COMPLEX FREQUENCY", "BUCKLE", "VISCO",
    "STEADY STATE DYNAMICS", "MODAL DYNAMIC", "RANDOM RESPONSE", "RESPONSE SPECTRUM", "SPECTRUM",
    "PSD-DEFINITION", "CORRELATION", "MODAL DAMPING", "SELECT EIGENMODES", "BASE MOTION",
    "AMPLITUDE", "DAMPING", "GLOBAL DAMPING", "COMPOSITE MODAL DAMPING", "DASHPOT", "HEAT TRANSFER",
    "COUPLED TEMPERATURE-DISPLACEMENT", "UNCOUPLED TEMPERATURE-DISPLACEMENT", "GEOSTATIC",
    "SOLVER CONTROLS", "CONTROLS", "RETAINED NODAL DOFS", "SUBSTRUCTURE GENERATE",
    "SUBSTRUCTURE MATRIX OUTPUT", "SUBSTRUCTURE OUTPUT", "ANNEAL", "SECTION CONTROLS",
    "PHYSICAL CONSTANTS", "VIEWFACTOR", "SENSITIVITY", "DESIGN VARIABLES", "DESIGN RESPONSE",
    "OBJECTIVE", "CONSTRAINT", "FIXED MASS SCALING", "VARIABLE MASS SCALING", "BULK VISCOSITY",
    "ADAPTIVE MESH", "CRACK PROPAGATION", "GREEN", "CYCLIC", "PARAMETER", "CONTOUR INTEGRAL",
    "LOAD CASE", "END LOAD CASE", "PERTURBATION", "STEADY STATE", "COUPLED",
    // loads, temperatures
    "CLOAD", "DLOAD", "DSLOAD", "DFLUX", "CFLUX", "DSFLUX", "FILM", "SFILM", "CFILM", "RADIATE",
    "SRADIATE", "TEMPERATURE", "FIELD", "INITIAL CONDITIONS", "INERTIA RELIEF", "BASE", "CAVITY",
    "PRESSURE STRESS", "SECTION FORCE", "CHANGE FRICTION", "CHANGE SURFACE BEHAVIOR",
    "MASS FLOW RATE", "CHANGE SOLID SECTION", "CHANGE CONTACT TYPE", "EMBEDDED LOAD",
    "INCIDENT WAVE",
    // materials beyond their elastic law
    "EXPANSION", "CONDUCTIVITY", "SPECIFIC HEAT", "LATENT HEAT", "INELASTIC HEAT FRACTION",
    "PLASTIC", "RATE DEPENDENT", "CYCLIC HARDENING", "CREEP", "VISCOELASTIC",
    "DEFORMATION PLASTICITY", "DAMAGE INITIATION", "DAMAGE EVOLUTION", "FAIL STRESS", "FAIL STRAIN",
    "DAMAGE STABILIZATION", "CONCRETE DAMAGED PLASTICITY", "CONCRETE TENSION STIFFENING",
    "CONCRETE COMPRESSION HARDENING", "CONCRETE TENSION DAMAGE", "CONCRETE COMPRESSION DAMAGE",
    "SHEAR FAILURE", "TENSILE FAILURE", "DRUCKER PRAGER", "DRUCKER PRAGER HARDENING",
    "MOHR COULOMB", "MOHR COULOMB HARDENING", "POTENTIAL", "ELECTRICAL CONDUCTIVITY",
    "PERMEABILITY", "HEAT GENERATION", "DEPVAR", "USER OUTPUT VARIABLES", "VALUES AT INFINITY",
    "GAP CONDUCTANCE", "GAP HEAT GENERATION", "NO COMPRESSION",
    // sets, axes and laws that act through what uses them
    "DISTRIBUTION", "DISTRIBUTION TABLE", "SURFACE INTERACTION", "SURFACE BEHAVIOR", "FRICTION",
    "CONTACT CONTROLS", "CONTACT DAMPING", "FUNCTION"};

// These change stiffness, mass or supports: never left away without a word.
const std::set<std::string> keywords_not_had{"CONTACT PAIR",
                                             "CONTACT",
                                             "CONTACT INCLUSIONS",
                                             "CLEARANCE",
                                             "TIE",
                                             "CYCLIC SYMMETRY MODEL",
                                             "PRE-TENSION SECTION",
                                             "CONNECTOR SECTION",
                                             "CONNECTOR BEHAVIOR",
                                             "CONNECTOR ELASTICITY",
                                             "UEL PROPERTY",
                                             "USER MATERIAL",
                                             "HYPERELASTIC",
                                             "HYPERFOAM",
                                             "SUBSTRUCTURE PROPERTY",
                                             "SHELL TO SOLID COUPLING",
                                             "EMBEDDED ELEMENT",
                                             "FASTENER",
                                             "MODEL CHANGE",
                                             "RELEASE",
                                             "GAP",
                                             "GASKET SECTION",
                                             "COHESIVE SECTION",
                                             "FLUID SECTION",
                                             "NONSTRUCTURAL MASS",
                                             "NMAP",
                                             "SUBMODEL",
                                             "IMPORT",
                                             "REBAR",
                                             "REBAR LAYER",
                                             "IMPERFECTION",
                                             "JOINT",
                                             "FRAME SECTION",
                                             "SURFACE SECTION",
                                             "SYMMETRIC MODEL GENERATION",
                                             "HOURGLASS STIFFNESS",
                                             "ELASTIC FOUNDATION",
                                             "FOUNDATION",
                                             "NETWORK MPC",
                                             "STIFFENER",
                                             "INERTIA",
                                             "ADJUST",
                                             "NONLINEAR BH",
                                             "PERIODIC",
                                             "HEADING MODEL"};

bool type_begins(const std::string& type, const std::vector<std::string>& beginnings) {
  return std::any_of(beginnings.begin(), beginnings.end(),
                     [&](const std::string& b) { return type.starts_with(b); });
}

} // namespace

KeywordKind kind_of_keyword(const std::string& name) {
  if (passed_keywords.contains(name)) return KeywordKind::passed;
  return keywords_not_had.contains(name) ? KeywordKind::structural : KeywordKind::unknown;
}

std::vector<std::string> passed_or_structural_keywords() {
  std::vector<std::string> names(passed_keywords.begin(), passed_keywords.end());
  names.insert(names.end(), keywords_not_had.begin(), keywords_not_had.end());
  return names;
}

bool is_solid_type(const std::string& type) {
  return type_begins(type,
                     {"C3D", "CPS", "CPE", "CAX", "CGAX", "CCL", "DC",  "AC",  "COH", "EC3D", "F3D",
                      "SC6", "SC8", "CSS", "CIN", "SAX",  "DS",  "MAX", "SFM", "Q3D", "PC3D"});
}

bool is_idle_type(const std::string& type) {
  return type == "DASHPOT1" || type == "DASHPOT2" || type == "DASHPOTA" || type == "R3D3" ||
         type == "R3D4" || type == "RB3D2" || type == "R2D2" || type == "RAX2";
}

} // namespace plica
