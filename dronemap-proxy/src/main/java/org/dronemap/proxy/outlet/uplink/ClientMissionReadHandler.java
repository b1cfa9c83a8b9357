package org.dronemap.proxy.outlet.uplink;

import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import org.dronemap.core.access.Principal;
import org.dronemap.core.cloud.CloudManager;
import org.dronemap.core.command.Command;
import org.dronemap.core.command.Outcome;
import org.dronemap.core.command.ReadFence;
import org.dronemap.core.command.ReadRallyPoints;
import org.dronemap.core.command.SetFence;
import org.dronemap.core.drone.DroneId;
import org.dronemap.core.drone.DroneState;
import org.dronemap.core.drone.Home;
import org.dronemap.core.drone.OnboardFence;
import org.dronemap.core.drone.OnboardRallyPoints;
import org.dronemap.mavlink.Frame;
import org.dronemap.mavlink.message.Heartbeat;
import org.dronemap.mavlink.message.MissionAck;
import org.dronemap.mavlink.message.MissionCount;
import org.dronemap.mavlink.message.MissionItemInt;
import org.dronemap.mavlink.message.MissionRequest;
import org.dronemap.mavlink.message.MissionRequestInt;
import org.dronemap.mavlink.message.MissionRequestList;
import org.dronemap.proxy.mavlink.procedure.LegacyMissionItems;
import org.dronemap.proxy.mavlink.procedure.MavMissionType;
import org.dronemap.proxy.mavlink.procedure.MavlinkTarget;
import org.dronemap.proxy.mavlink.translate.AutopilotAdapter;
import org.dronemap.proxy.mavlink.translate.FenceCodec;
import org.jspecify.annotations.Nullable;

/**
 * Serves the cloud's copy of missions, fences and rally points to ground stations at the outlet. Owned by the outlet's
 * thread.
 */
final class ClientMissionReadHandler {
    static final int ACK_ACCEPTED = 0;
    static final int ACK_ERROR = 1;
    static final int ACK_UNSUPPORTED = 3;
    static final int ACK_NO_SPACE = 4;
    static final int ACK_INVALID_SEQUENCE = 13;
    static final int ACK_DENIED = 14;
    private static final int MOST_LISTS = 512;
    private static final int WAYPOINT = 16;
    private static final double E7 = 1e7;

    private final CloudManager cloud;
    private final ClientCommandExecutor orders;
    private final Map<TransferKey, List<MissionItemInt>> lists = new LinkedHashMap<>() {
        private static final long serialVersionUID = 1L;

        @Override
        protected boolean removeEldestEntry(Map.Entry<TransferKey, List<MissionItemInt>> eldest) {
            return size() > MOST_LISTS;
        }
    };

    private record TransferKey(String client, DroneId drone, int kind) {}

    ClientMissionReadHandler(CloudManager cloud, ClientCommandExecutor orders) {
        this.cloud = cloud;
        this.orders = orders;
    }

    /** MISSION_REQUEST_LIST: what is counted now is what the client gets, whatever changes meanwhile. */
    void list(ClientRequest asked) {
        int kind = MissionRequestList.decode(asked.frame()).missionType();
        if (kind < 0 || kind > MavMissionType.RALLY.number()) {
            acknowledge(asked, ACK_UNSUPPORTED, kind);
            return;
        }
        List<MissionItemInt> items = items(asked, kind);
        if (items != null) {
            count(asked, kind, items);
        } else if (!leftOut(asked, kind).isEmpty()) {
            acknowledge(asked, ACK_UNSUPPORTED, kind);
            asked.explain("Not all that the vehicle has can be shown: " + String.join(" ", leftOut(asked, kind)));
        } else if (kind != MavMissionType.MISSION.number()) {
            read(asked, kind);
        }
        // A mission that is not known yet is being read: clients ask again.
    }

    private void count(ClientRequest asked, int kind, List<MissionItemInt> items) {
        lists.put(new TransferKey(asked.client().id(), asked.drone(), kind), items);
        asked.answer(new MissionCount(asked.fromSystem(), asked.fromComponent(), items.size(), kind));
    }

    /** Null when the cloud does not know it, or not whole. */
    private @Nullable List<MissionItemInt> items(ClientRequest asked, int kind) {
        MavlinkTarget here = new MavlinkTarget(0, 0, message -> {});
        if (kind == MavMissionType.FENCE.number()) {
            OnboardFence fence = cloud.onBoard(asked.drone()).fence();
            return fence == null || !fence.leftOut().isEmpty()
                    ? null
                    : FenceCodec.fenceToWire(new SetFence(fence.areas(), fence.returnPoint()), here);
        }
        if (kind == MavMissionType.RALLY.number()) {
            OnboardRallyPoints rally = cloud.onBoard(asked.drone()).rallyPoints();
            return rally == null || !rally.leftOut().isEmpty() ? null : FenceCodec.rallyToWire(rally.points(), here);
        }
        return asked.vehicle().mission();
    }

    /** What the vehicle has and cannot be shown; a client that got the rest would write back a part for the whole. */
    private List<String> leftOut(ClientRequest asked, int kind) {
        OnboardFence fence = cloud.onBoard(asked.drone()).fence();
        OnboardRallyPoints rally = cloud.onBoard(asked.drone()).rallyPoints();
        if (kind == MavMissionType.FENCE.number()) {
            return fence == null ? List.of() : fence.leftOut();
        }
        return kind == MavMissionType.MISSION.number() || rally == null ? List.of() : rally.leftOut();
    }

    /** Has it read by the vehicle's only reader, if the user may. */
    private void read(ClientRequest asked, int kind) {
        Principal principal = asked.client().principal();
        if (principal == null || !asked.client().mayOrder()) {
            return;
        }
        Command command = kind == MavMissionType.FENCE.number() ? new ReadFence() : new ReadRallyPoints();
        orders.submit(principal, asked.drone(), command, new ClientCommandExecutor.Callback() {
            @Override
            public void accepted() {
                // The list itself is the answer.
            }

            @Override
            public void ended(Outcome outcome) {
                List<MissionItemInt> items = items(asked, kind);
                if (items != null) {
                    count(asked, kind, items);
                } else {
                    acknowledge(asked, ACK_DENIED, kind);
                    asked.explain(OutcomeTranslator.sentence(outcome));
                }
            }
        });
    }

    /** MISSION_REQUEST_INT. */
    void item(ClientRequest asked) {
        MissionRequestInt wanted = MissionRequestInt.decode(asked.frame());
        MissionItemInt item = item(asked, wanted.missionType(), wanted.seq());
        if (item != null) {
            asked.answer(item);
        }
    }

    /** MISSION_REQUEST, as older clients ask. */
    void olderItem(ClientRequest asked) {
        MissionRequest wanted = MissionRequest.decode(asked.frame());
        MissionItemInt item = item(asked, wanted.missionType(), wanted.seq());
        if (item != null) {
            asked.answer(LegacyMissionItems.older(item));
        }
    }

    private @Nullable MissionItemInt item(ClientRequest asked, int kind, int seq) {
        List<MissionItemInt> items = lists.get(new TransferKey(asked.client().id(), asked.drone(), kind));
        MissionItemInt home = items != null && items.isEmpty() && seq == 0 ? home(asked, kind) : null;
        if (home != null) {
            return addressed(home, asked, seq);
        }
        if (items == null || seq >= items.size()) {
            acknowledge(asked, ACK_INVALID_SEQUENCE, kind);
            return null;
        }
        return addressed(items.get(seq), asked, seq);
    }

    /** Autopilots that keep home as item 0 show it also where there is no mission, and programs count on it. */
    private @Nullable MissionItemInt home(ClientRequest asked, int kind) {
        Frame beat = asked.vehicle().newest(Heartbeat.ID);
        Home home = cloud.drone(asked.drone()).map(DroneState::home).orElse(null);
        boolean kept =
                beat != null && AutopilotAdapter.of(Heartbeat.decode(beat)).itemsBeforeMission() > 0;
        if (home == null || !kept || kind != MavMissionType.MISSION.number()) {
            return null;
        }
        int x = (int) Math.round(home.point().latitudeDegrees() * E7);
        int y = (int) Math.round(home.point().longitudeDegrees() * E7);
        float z = (float) home.altitudeAmslMeters();
        return new MissionItemInt(0, 0, 0, 0, WAYPOINT, 0, 1, 0, 0, 0, 0, x, y, z, kind);
    }

    static void acknowledge(ClientRequest asked, int type, int kind) {
        asked.answer(new MissionAck(asked.fromSystem(), asked.fromComponent(), type, kind));
    }

    private static MissionItemInt addressed(MissionItemInt item, ClientRequest asked, int seq) {
        return new MissionItemInt(
                asked.fromSystem(),
                asked.fromComponent(),
                seq,
                item.frame(),
                item.command(),
                item.current(),
                item.autocontinue(),
                item.param1(),
                item.param2(),
                item.param3(),
                item.param4(),
                item.x(),
                item.y(),
                item.z(),
                item.missionType());
    }

    /** The client has gone. */
    void forget(String client) {
        lists.keySet().removeIf(place -> place.client().equals(client));
    }
}
