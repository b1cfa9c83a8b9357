package org.dronemap.proxy.outlet.uplink;

import java.util.LinkedHashMap;
import java.util.Map;
import org.dronemap.core.access.Principal;
import org.dronemap.core.cloud.CloudManager;
import org.dronemap.core.command.Command;
import org.dronemap.core.command.CommandKind;
import org.dronemap.core.command.Contention;
import org.dronemap.core.command.Outcome;
import org.dronemap.core.drone.DroneId;
import org.dronemap.core.drone.DroneState;
import org.dronemap.core.geo.Geodetic;
import org.dronemap.core.mission.Altitude;
import org.dronemap.mavlink.Frame;
import org.dronemap.mavlink.message.CommandAck;
import org.dronemap.mavlink.message.CommandInt;
import org.dronemap.mavlink.message.CommandLong;
import org.dronemap.mavlink.message.Heartbeat;
import org.dronemap.mavlink.message.MissionItem;
import org.dronemap.mavlink.message.SetMode;
import org.dronemap.proxy.outlet.client.ClientMessage;
import org.jspecify.annotations.Nullable;

/**
 * Handles MAVLink commands of ground stations at the outlet: executes those allowed and acknowledges each. A command
 * that is sent again while it waits acts once. Owned by the outlet's thread.
 */
final class ClientCommandHandler {
    private static final long LATE_NANOS = 3_000_000_000L;
    private static final int MOST_REMEMBERED = 1_024;
    private static final double E7 = 1e7;

    private final CloudManager cloud;
    private final ClientCommandExecutor orders;
    private final ClientControlHandler controls;
    private final Map<CommandKey, IssuedCommand> given = new LinkedHashMap<>() {
        private static final long serialVersionUID = 1L;

        @Override
        protected boolean removeEldestEntry(Map.Entry<CommandKey, IssuedCommand> eldest) {
            return size() > MOST_REMEMBERED;
        }
    };

    private record CommandKey(String client, DroneId drone, int number) {}

    /** {@code result} null: not answered yet. */
    private record IssuedCommand(Command command, @Nullable Integer result, long nanos) {}

    ClientCommandHandler(CloudManager cloud, ClientCommandExecutor orders, ClientControlHandler controls) {
        this.cloud = cloud;
        this.orders = orders;
        this.controls = controls;
    }

    /** COMMAND_LONG, COMMAND_INT or SET_MODE. */
    void handle(ClientRequest asked, long now) {
        Frame frame = asked.frame();
        Frame beat = asked.vehicle().newest(Heartbeat.ID);
        DroneState state = cloud.drone(asked.drone()).orElse(null);
        if (beat == null || state == null) {
            return;
        }
        CommandInt command = command(frame);
        ClientCommandReader.Context context = new ClientCommandReader.Context(command, Heartbeat.decode(beat), state);
        ClientIntent wish = ClientCommandReader.of(context);
        int number = command.command();
        if (frame.messageId() == SetMode.ID) {
            SetMode mode = SetMode.decode(frame);
            wish = new ClientIntent.Order(
                    new Command.SetMode(ClientCommandReader.modeName(context, mode.baseMode(), mode.customMode())));
            number = SetMode.ID;
        }
        if (wish instanceof ClientIntent.Order order && isForAnother(asked, command) && !isPayload(order.command())) {
            wish = new ClientIntent.Denied(
                    "This is for component " + command.targetComponent() + "; send it to the autopilot.");
        }
        String remark = ClientCommandReader.remark(context);
        if (remark != null && asked.client().mayOrder()) {
            asked.explain(remark);
        }
        boolean again =
                frame.messageId() == CommandLong.ID && CommandLong.decode(frame).confirmation() > 0;
        grant(asked, number, wish, again, now);
    }

    private static boolean isForAnother(ClientRequest asked, CommandInt command) {
        return command.targetComponent() != 0
                && command.targetComponent() != asked.vehicle().component();
    }

    /** Cameras and switches are components of their own for many programs; here all is the vehicle's. */
    private static boolean isPayload(Command command) {
        return switch (command.kind().contention()) {
            case CAMERA, RELAY -> true;
            case ARMING, FLIGHT, SPEED, TRANSFER, PARAMETERS, LOGS, HOME, MAP -> false;
        };
    }

    /** MISSION_ITEM that is no part of a mission: where to go now, as autopilots take it in GUIDED. */
    void goTo(ClientRequest asked) {
        MissionItem item = MissionItem.decode(asked.frame());
        Altitude altitude = ClientCommandReader.altitude(item.frame(), item.z());
        Principal principal = asked.client().principal();
        boolean place = Math.abs(item.x()) <= 90 && Math.abs(item.y()) <= 180;
        if (altitude == null || !place || principal == null || !asked.client().mayOrder()) {
            ClientMissionReadHandler.acknowledge(asked, ClientMissionReadHandler.ACK_DENIED, 0);
            return;
        }
        Command command = new Command.GoTo(new Geodetic(item.x(), item.y()), altitude);
        orders.submit(principal, asked.drone(), command, new GoToAcknowledger(asked));
    }

    private void grant(ClientRequest asked, int number, ClientIntent wish, boolean again, long now) {
        if (asked.client().onlyLooks() && changes(wish)) {
            acknowledge(asked, number, OutcomeTranslator.DENIED);
            asked.explain("This is a port to look only; to command, sign.");
        } else if (wish instanceof ClientIntent.Order order) {
            order(asked, number, order.command(), again, now);
        } else if (changes(wish)) {
            controls.handle(asked, wish);
        } else if (wish instanceof ClientIntent.Show show) {
            Frame newest = asked.vehicle().newest(show.messageId());
            acknowledge(
                    asked,
                    number,
                    newest == null ? OutcomeTranslator.TEMPORARILY_REJECTED : OutcomeTranslator.ACCEPTED);
            if (newest != null) {
                asked.client().enqueue(new ClientMessage.OfVehicle(asked.drone(), newest));
            }
        } else if (wish instanceof ClientIntent.Granted) {
            acknowledge(asked, number, OutcomeTranslator.ACCEPTED);
        } else if (wish instanceof ClientIntent.Denied denied) {
            acknowledge(asked, number, OutcomeTranslator.DENIED);
            asked.explain(denied.sentence());
        } else {
            acknowledge(asked, number, OutcomeTranslator.UNSUPPORTED);
            asked.explain("Command " + number + " does not pass the cloud.");
        }
    }

    private static boolean changes(ClientIntent wish) {
        return wish instanceof ClientIntent.Order
                || wish instanceof ClientIntent.Control
                || wish instanceof ClientIntent.Release;
    }

    private void order(ClientRequest asked, int number, Command command, boolean again, long now) {
        CommandKey place = new CommandKey(asked.client().id(), asked.drone(), number);
        IssuedCommand before = given.get(place);
        if (before != null && before.command().equals(command)) {
            Integer result = before.result();
            if (result == null) {
                return;
            }
            if (again && now - before.nanos() < LATE_NANOS) {
                acknowledge(asked, number, result);
                return;
            }
        }
        Principal principal = asked.client().principal();
        if (principal == null) {
            return;
        }
        if (!asked.client().mayOrder()) {
            acknowledge(asked, number, OutcomeTranslator.TEMPORARILY_REJECTED);
            return;
        }
        IssuedCommand mine = new IssuedCommand(command, null, now);
        given.put(place, mine);
        orders.submit(principal, asked.drone(), command, new Acknowledging(asked, place, mine));
    }

    /** Acknowledges once: when the vehicle has taken the command, or when it is over before. */
    private final class Acknowledging implements ClientCommandExecutor.Callback {
        private final ClientRequest asked;
        private final CommandKey place;
        private final IssuedCommand mine;
        private boolean answered;

        Acknowledging(ClientRequest asked, CommandKey place, IssuedCommand mine) {
            this.asked = asked;
            this.place = place;
            this.mine = mine;
        }

        @Override
        public void accepted() {
            // What comes next counts on it: only what was seen to be so is said to be.
            if (!isSoonSeen(mine.command())) {
                answer(OutcomeTranslator.ACCEPTED);
            }
        }

        @Override
        public void ended(Outcome outcome) {
            answer(OutcomeTranslator.result(outcome));
            String why = OutcomeTranslator.sentence(outcome);
            if (!why.isEmpty()) {
                asked.explain(why);
            }
        }

        private void answer(int result) {
            if (!answered) {
                answered = true;
                // A newer command of the same kind has the place by now.
                given.replace(place, mine, new IssuedCommand(mine.command(), result, mine.nanos()));
                acknowledge(asked, place.number(), result);
            }
        }
    }

    private static boolean isSoonSeen(Command command) {
        return command.kind().contention() == Contention.ARMING || command.kind() == CommandKind.SET_MODE;
    }

    /** Acknowledges a place to go to as the item that it came as. */
    private static final class GoToAcknowledger implements ClientCommandExecutor.Callback {
        private final ClientRequest asked;
        private boolean answered;

        GoToAcknowledger(ClientRequest asked) {
            this.asked = asked;
        }

        @Override
        public void accepted() {
            answer(ClientMissionReadHandler.ACK_ACCEPTED);
        }

        @Override
        public void ended(Outcome outcome) {
            boolean done = outcome instanceof Outcome.Succeeded;
            answer(done ? ClientMissionReadHandler.ACK_ACCEPTED : ClientMissionReadHandler.ACK_DENIED);
            if (!done) {
                asked.explain(OutcomeTranslator.sentence(outcome));
            }
        }

        private void answer(int type) {
            if (!answered) {
                answered = true;
                ClientMissionReadHandler.acknowledge(asked, type, 0);
            }
        }
    }

    private static void acknowledge(ClientRequest asked, int number, int result) {
        asked.answer(new CommandAck(number, result, 0, 0, asked.fromSystem(), asked.fromComponent()));
    }

    private static CommandInt command(Frame frame) {
        if (frame.messageId() == CommandInt.ID) {
            return CommandInt.decode(frame);
        }
        if (frame.messageId() == SetMode.ID) {
            SetMode mode = SetMode.decode(frame);
            return new CommandInt(mode.targetSystem(), 0, 0, ClientCommandReader.SET_MODE, 0, 0, 0, 0, 0, 0, 0, 0, 0);
        }
        CommandLong command = CommandLong.decode(frame);
        return new CommandInt(
                command.targetSystem(),
                command.targetComponent(),
                0,
                command.command(),
                0,
                0,
                command.param1(),
                command.param2(),
                command.param3(),
                command.param4(),
                degrees7(command.param5()),
                degrees7(command.param6()),
                command.param7());
    }

    /** What is no place on Earth stays none. */
    private static int degrees7(float degrees) {
        return Math.abs(degrees) <= 200 ? (int) Math.round(degrees * E7) : Integer.MAX_VALUE;
    }
}
