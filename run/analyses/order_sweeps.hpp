// The orders of an engine while its speed runs as given over time, beside the steady response at
// every speed (run_ups.hpp).
#pragma once

#include "run/analyses/sensor_model.hpp"

namespace plica {

// The amplitude of an order's input at a speed (revolutions per second).
double amplitude_at(const EngineOrder& order, double speed);

// `key`: of the run-up, whose table says speed over time. Every order begins steadily. Warns where
// it is too long for damping that couples modes. Throws InputError for a run-up of more than 20
// million samples.
OrderSweeps order_sweeps(const RunUp& asked, const std::string& key, const SensorModel& model,
                         const DampedModes& modes, const Excitations& excited,
                         std::vector<std::string>& warnings);

// What the order reaches around a crossing, from the middles to the crossings of the same order
// beside it.
double reached(const OrderSweeps& sweeps, const OrderCrossing& crossing,
               const std::vector<OrderCrossing>& all);

} // namespace plica
