package org.dronemap.ws.flights;

import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.Deque;
import java.util.List;
import java.util.Map;
import org.dronemap.mavlink.Frame;
import org.dronemap.mavlink.message.CommandInt;
import org.dronemap.mavlink.message.CommandLong;
import org.dronemap.ws.lab.Laboratory;
import org.dronemap.ws.lab.ScriptedPeer;

/** A copter in the air that carries out whatever reaches it, as often as it does, and writes it down. */
final class CountingCopter {
    static final int GUIDED = 4;
    static final int RTL = 6;
    static final int LAND = 9;

    /** Doing these twice is once too often. */
    static final Map<Integer, String> ONCE = Map.of(2000, "takePicture", 181, "setRelay", 115, "turn");

    private static final Map<Integer, String> REPEATABLE = Map.of(176, "setMode", 192, "goTo");
    private static final int MOST_REMEMBERED = 64;

    private final Laboratory lab;
    private final ScriptedPeer peer;
    private final List<Act> log = new ArrayList<>();
    private final Deque<byte[]> frames = new ArrayDeque<>();

    /** One line of its log: what it carried out, and when. */
    record Act(long nanos, String kind, List<Double> parameters) {}

    CountingCopter(Laboratory lab, int systemId) {
        this.lab = lab;
        this.peer = lab.peer(systemId, ScriptedPeer.Kind.COPTER, this::receive);
        peer.isIn(GUIDED);
        peer.isInTheAir();
    }

    private void receive(ScriptedPeer self, Frame frame) {
        boolean isOrder = frame.messageId() == CommandLong.ID || frame.messageId() == CommandInt.ID;
        if (!isOrder || isTheNetworksOwnDuplicate(frame)) {
            return;
        }
        if (frame.messageId() == CommandLong.ID) {
            CommandLong order = CommandLong.decode(frame);
            obey(order.command(), List.of((double) order.param1(), (double) order.param2(), (double) order.param3()));
        } else {
            CommandInt order = CommandInt.decode(frame);
            obey(order.command(), List.of((double) order.x(), (double) order.y()));
        }
    }

    /** As a receiver that looks at sequence numbers knows. */
    private boolean isTheNetworksOwnDuplicate(Frame frame) {
        byte[] bytes = frame.bytes();
        if (frames.stream().anyMatch(before -> Arrays.equals(before, bytes))) {
            return true;
        }
        frames.addLast(bytes);
        if (frames.size() > MOST_REMEMBERED) {
            frames.removeFirst();
        }
        return false;
    }

    private void obey(int command, List<Double> parameters) {
        String kind = ONCE.getOrDefault(command, REPEATABLE.get(command));
        if (kind == null) {
            peer.acknowledges(command, ScriptedPeer.UNSUPPORTED);
            return;
        }
        log.add(new Act(lab.time().nanos(), kind, parameters));
        peer.acknowledges(command, ScriptedPeer.ACCEPTED);
        if (kind.equals("setMode")) {
            peer.isIn(parameters.get(1).longValue());
        } else {
            peer.beat();
        }
    }

    ScriptedPeer peer() {
        return peer;
    }

    List<Act> log() {
        return List.copyOf(log);
    }
}
