package org.dronemap.ws.flights.separation;

import java.time.Duration;
import java.util.List;
import java.util.Locale;
import org.dronemap.core.access.Role;
import org.dronemap.mavlink.message.CommandLong;
import org.dronemap.sim.autopilot.MavCmd;
import org.dronemap.sim.autopilot.MavCommand;
import org.dronemap.ws.command.BroadcastRequest;
import org.dronemap.ws.command.CommandRequest;
import org.dronemap.ws.lab.CommandRequests;
import org.dronemap.ws.lab.LabDrone;
import org.dronemap.ws.lab.LabVehicleLink;
import org.dronemap.ws.lab.Laboratory;
import org.dronemap.ws.lab.Pilot;

/** Something that comes between, at any moment of a flight. */
enum Disturbance {
    NONE,

    /** A supervisor has all of them hold. */
    HOLD_ALL {
        @Override
        void begin(Laboratory lab, List<LabDrone> drones) {
            all(lab, CommandRequests.hold());
        }
    },

    /** A supervisor calls all of them home. */
    RECALL_ALL {
        @Override
        void begin(Laboratory lab, List<LabDrone> drones) {
            all(lab, CommandRequests.returnToLaunch());
        }
    },

    /** One does not receive anything any more, and goes on reporting. */
    DEAF {
        @Override
        void begin(Laboratory lab, List<LabDrone> drones) {
            chosen(drones).vehicle().setDeaf(true);
        }
    },

    /** One receives everything two seconds late, and is received as late. */
    LATE {
        @Override
        void begin(Laboratory lab, List<LabDrone> drones) {
            chosen(drones).wire().is(LabVehicleLink.Quality.late(LATE_MILLIS));
        }
    },

    /** A pilot who stands beside one has it stay where it is, and lands it there a minute later. */
    PILOT {
        @Override
        void begin(Laboratory lab, List<LabDrone> drones) {
            LabDrone drone = chosen(drones);
            if (!drone.isDown()) {
                drone.switchedTo(LOITER);
            }
        }

        @Override
        void end(Laboratory lab, List<LabDrone> drones) {
            LabDrone drone = chosen(drones);
            if (!drone.isDown() && drone.mode() == LOITER) {
                drone.switchedTo(LAND);
            }
        }
    },

    /** The server is killed, and does not come back: vehicles are left to themselves. */
    KILLED {
        @Override
        void begin(Laboratory lab, List<LabDrone> drones) {
            lab.crashServer();
        }
    },

    /** The server is killed, and another one takes up what it left. */
    RESTARTED {
        @Override
        void begin(Laboratory lab, List<LabDrone> drones) {
            lab.crashServer();
        }

        @Override
        void end(Laboratory lab, List<LabDrone> drones) {
            lab.startServer();
        }

        @Override
        Duration lasts() {
            return DOWN;
        }
    },

    /** One falls silent and stays where it is; a minute later it reports again. */
    SILENT {
        @Override
        void begin(Laboratory lab, List<LabDrone> drones) {
            LabDrone drone = chosen(drones);
            drone.wire().cut();
            var unused = drone.vehicle()
                    .autopilot()
                    .execute(MavCommand.of(new CommandLong(
                            drone.vehicle().systemId(), 1, MavCmd.PAUSE_CONTINUE, 0, 0, 0, 0, 0, 0, 0, 0)));
        }

        @Override
        void end(Laboratory lab, List<LabDrone> drones) {
            chosen(drones).wire().mend();
        }
    };

    private static final Duration LASTS = Duration.ofSeconds(60);
    private static final Duration DOWN = Duration.ofSeconds(20);

    private static final long LATE_MILLIS = 2_000;
    private static final long LOITER = 5;
    private static final long LAND = 9;

    void begin(Laboratory lab, List<LabDrone> drones) {}

    void end(Laboratory lab, List<LabDrone> drones) {}

    /** From its beginning to its end. */
    Duration lasts() {
        return LASTS;
    }

    final String words() {
        return name().toLowerCase(Locale.ROOT).replace('_', '-');
    }

    /** Operations end otherwise than they were meant to. */
    boolean changesOperations() {
        return this != NONE && this != LATE;
    }

    /** The last one: it belongs to the operation whose beginning was chosen so that it meets another. */
    private static LabDrone chosen(List<LabDrone> drones) {
        return drones.get(drones.size() - 1);
    }

    private static void all(Laboratory lab, CommandRequest command) {
        Pilot chief = lab.pilot("chief", Role.SUPERVISOR);
        var unused = lab.server()
                .broadcasts()
                .submit(chief.principal(), "laboratory", new BroadcastRequest(List.of("all"), command, null));
    }
}
