package org.dronemap.proxy.outlet.uplink;

import java.util.ArrayList;
import java.util.Iterator;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.dronemap.core.access.Principal;
import org.dronemap.core.cloud.CloudManager;
import org.dronemap.core.cloud.rule.CommandRules;
import org.dronemap.core.cloud.rule.RoleRules;
import org.dronemap.core.command.Command;
import org.dronemap.core.command.Outcome;
import org.dronemap.core.command.Refusal;
import org.dronemap.core.drone.Capability;
import org.dronemap.core.drone.DroneId;
import org.dronemap.core.drone.DroneState;
import org.dronemap.core.mission.Mission;
import org.dronemap.mavlink.Frame;
import org.dronemap.mavlink.message.Heartbeat;
import org.dronemap.mavlink.message.MissionClearAll;
import org.dronemap.mavlink.message.MissionCount;
import org.dronemap.mavlink.message.MissionItem;
import org.dronemap.mavlink.message.MissionItemInt;
import org.dronemap.mavlink.message.MissionRequest;
import org.dronemap.mavlink.message.MissionRequestInt;
import org.dronemap.proxy.mavlink.procedure.LegacyMissionItems;
import org.dronemap.proxy.mavlink.procedure.MavMissionType;
import org.dronemap.proxy.mavlink.translate.AutopilotAdapter;
import org.jspecify.annotations.Nullable;

/**
 * Receives missions, fences and rally points from ground stations at the outlet, and uploads them to the drone. What
 * the cloud cannot keep as it came is refused, never shortened. Owned by the outlet's thread.
 */
final class ClientMissionWriteHandler {
    private static final int MOST_ITEMS = Mission.MAX_ITEMS + 1;
    private static final int ALL_KINDS = 255;
    private static final long ASK_AGAIN_NANOS = 1_000_000_000L;
    private static final int MOST_TRIES = 8;

    private final CloudManager cloud;
    private final ClientCommandExecutor orders;
    private final Map<TransferKey, Upload> intakes = new LinkedHashMap<>();
    private final List<ClientRequest> due = new ArrayList<>();

    private record TransferKey(String client, DroneId drone) {}

    /** A mission, fence or rally point upload of one client for one drone. */
    private static final class Upload {
        private final ClientRequest asked;
        private final int kind;
        private final int count;
        private final List<MissionItemInt> items = new ArrayList<>();
        private int tries;
        private long askedNanos;
        private boolean older;
        private boolean given;
        /** Announced while this one was being cleared away; null: nothing. */
        private @Nullable ClientRequest next;

        Upload(ClientRequest asked, int kind, int count) {
            this.asked = asked;
            this.kind = kind;
            this.count = count;
        }
    }

    ClientMissionWriteHandler(CloudManager cloud, ClientCommandExecutor orders) {
        this.cloud = cloud;
        this.orders = orders;
    }

    /** MISSION_COUNT. */
    void begin(ClientRequest asked, long now) {
        MissionCount announced = MissionCount.decode(asked.frame());
        int kind = announced.missionType();
        if (kind > MavMissionType.RALLY.number()) {
            ClientMissionReadHandler.acknowledge(asked, ClientMissionReadHandler.ACK_UNSUPPORTED, kind);
            return;
        }
        Optional<String> why =
                whyNot(asked, announced.count() == 0 && kind == 0 ? Capability.CLEAR_MISSION : capability(kind));
        if (why.isPresent()) {
            refuse(asked, ClientMissionReadHandler.ACK_DENIED, kind, why.get());
            return;
        }
        TransferKey place = new TransferKey(asked.client().id(), asked.drone());
        Upload before = intakes.get(place);
        if (before != null && before.given) {
            // What is on its way is announced again by who is not patient; after a clearance it is something new.
            before.next = before.count == 0 ? asked : null;
            return;
        }
        if (announced.count() > MOST_ITEMS) {
            refuse(
                    asked,
                    ClientMissionReadHandler.ACK_NO_SPACE,
                    kind,
                    "A mission has at most " + Mission.MAX_ITEMS + " items.");
            return;
        }
        Upload intake = new Upload(asked, kind, announced.count());
        intakes.put(place, intake);
        goOn(place, intake, now);
    }

    /** MISSION_CLEAR_ALL. */
    void clear(ClientRequest asked, long now) {
        int kind = MissionClearAll.decode(asked.frame()).missionType();
        int cleared = kind == ALL_KINDS ? 0 : kind;
        if (cleared > MavMissionType.RALLY.number()) {
            ClientMissionReadHandler.acknowledge(asked, ClientMissionReadHandler.ACK_UNSUPPORTED, kind);
            return;
        }
        TransferKey place = new TransferKey(asked.client().id(), asked.drone());
        Upload before = intakes.get(place);
        if (before == null || !before.given) {
            Upload intake = new Upload(asked, cleared, 0);
            intakes.put(place, intake);
            goOn(place, intake, now);
        }
    }

    /** MISSION_ITEM_INT. */
    void item(ClientRequest asked, long now) {
        accept(asked, MissionItemInt.decode(asked.frame()), false, now);
    }

    /** MISSION_ITEM, as older clients send it. */
    void olderItem(ClientRequest asked, long now) {
        accept(asked, LegacyMissionItems.exact(MissionItem.decode(asked.frame())), true, now);
    }

    private void accept(ClientRequest asked, MissionItemInt item, boolean older, long now) {
        TransferKey place = new TransferKey(asked.client().id(), asked.drone());
        Upload intake = intakes.get(place);
        if (intake == null || intake.given || item.seq() != intake.items.size() || item.missionType() != intake.kind) {
            return;
        }
        intake.items.add(item);
        intake.tries = 0;
        intake.older = older;
        goOn(place, intake, now);
    }

    private void goOn(TransferKey place, Upload intake, long now) {
        if (intake.items.size() < intake.count) {
            ask(intake, intake.items.size(), now);
            return;
        }
        intake.given = true;
        intake.askedNanos = now;
        ClientMissionReader.Read read = read(intake);
        Principal principal = intake.asked.client().principal();
        if (read instanceof ClientMissionReader.Unsupported foreign) {
            intakes.remove(place);
            refuse(intake.asked, ClientMissionReadHandler.ACK_UNSUPPORTED, intake.kind, foreign.why());
        } else if (principal == null || !intake.asked.client().mayOrder()) {
            intakes.remove(place);
            ClientMissionReadHandler.acknowledge(intake.asked, ClientMissionReadHandler.ACK_DENIED, intake.kind);
        } else {
            Command command = ((ClientMissionReader.Understood) read).command();
            orders.submit(principal, intake.asked.drone(), command, new Acknowledging(place, intake));
        }
    }

    private static ClientMissionReader.Read read(Upload intake) {
        Frame beat = intake.asked.vehicle().newest(Heartbeat.ID);
        AutopilotAdapter autopilot = beat == null ? null : AutopilotAdapter.of(Heartbeat.decode(beat));
        return ClientMissionReader.of(intake.kind, intake.items, autopilot);
    }

    /** In the newer form first, in the older one to who does not answer that, and from then on in the one that was answered. */
    private static void ask(Upload intake, int seq, long now) {
        ClientRequest asked = intake.asked;
        intake.askedNanos = now;
        asked.answer(
                intake.older == (intake.tries % 2 == 1)
                        ? new MissionRequestInt(asked.fromSystem(), asked.fromComponent(), seq, intake.kind)
                        : new MissionRequest(asked.fromSystem(), asked.fromComponent(), seq, intake.kind));
    }

    /** Asks again for what does not come, and gives up; keeps those patient whose mission is on its way to the vehicle. */
    void advance(long now) {
        List<ClientRequest> next = List.copyOf(due);
        due.clear();
        next.forEach(asked -> begin(asked, now));
        for (Iterator<Upload> each = intakes.values().iterator(); each.hasNext(); ) {
            Upload intake = each.next();
            if (now - intake.askedNanos < ASK_AGAIN_NANOS) {
                continue;
            }
            if (intake.given) {
                intake.askedNanos = now;
                if (intake.count > 0) {
                    ask(intake, intake.count - 1, now);
                }
            } else if (++intake.tries > MOST_TRIES) {
                each.remove();
                ClientMissionReadHandler.acknowledge(intake.asked, ClientMissionReadHandler.ACK_ERROR, intake.kind);
            } else {
                ask(intake, intake.items.size(), now);
            }
        }
    }

    private Optional<String> whyNot(ClientRequest asked, Capability capability) {
        Principal principal = asked.client().principal();
        DroneState state = cloud.drone(asked.drone()).orElse(null);
        if (principal == null || state == null) {
            return Optional.of("There is no such drone.");
        }
        return RoleRules.whyNot(principal, state, capability)
                .or(() -> CommandRules.whyNot(state, capability))
                .map(Refusal::sentence);
    }

    private static Capability capability(int kind) {
        if (kind == MavMissionType.FENCE.number()) {
            return Capability.FENCE;
        }
        return kind == MavMissionType.RALLY.number() ? Capability.RALLY_POINTS : Capability.UPLOAD_MISSION;
    }

    private static void refuse(ClientRequest asked, int type, int kind, String why) {
        ClientMissionReadHandler.acknowledge(asked, type, kind);
        asked.explain(why);
    }

    /** The client has gone; what was given goes on. */
    void forget(String client) {
        intakes.keySet().removeIf(place -> place.client().equals(client));
    }

    /** Acknowledges when the vehicle has it, or not. */
    private final class Acknowledging implements ClientCommandExecutor.Callback {
        private final TransferKey place;
        private final Upload intake;

        Acknowledging(TransferKey place, Upload intake) {
            this.place = place;
            this.intake = intake;
        }

        @Override
        public void accepted() {
            // Only the whole counts.
        }

        @Override
        public void ended(Outcome outcome) {
            intakes.remove(place, intake);
            switch (outcome.kind()) {
                case SUCCEEDED ->
                    ClientMissionReadHandler.acknowledge(
                            intake.asked, ClientMissionReadHandler.ACK_ACCEPTED, intake.kind);
                case REFUSED ->
                    refuse(
                            intake.asked,
                            ClientMissionReadHandler.ACK_DENIED,
                            intake.kind,
                            OutcomeTranslator.sentence(outcome));
                case FAILED, TIMED_OUT, SUPERSEDED, UNKNOWN ->
                    refuse(
                            intake.asked,
                            ClientMissionReadHandler.ACK_ERROR,
                            intake.kind,
                            OutcomeTranslator.sentence(outcome));
            }
            if (intake.next != null) {
                due.add(intake.next);
            }
        }
    }
}
