package org.dronemap.ws.lab;

import java.nio.ByteBuffer;
import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.function.Function;
import java.util.function.Predicate;
import org.dronemap.mavlink.Frame;
import org.dronemap.mavlink.FrameReader;
import org.dronemap.mavlink.FrameWriter;
import org.dronemap.mavlink.Message;
import org.dronemap.mavlink.message.MissionAck;
import org.dronemap.mavlink.message.MissionCount;
import org.dronemap.mavlink.message.MissionItemInt;
import org.dronemap.mavlink.message.MissionRequest;
import org.dronemap.mavlink.message.MissionRequestInt;
import org.dronemap.mavlink.message.MissionRequestList;

/** A ground station that is plugged straight into a vehicle, past its wire and past the server. */
public final class DirectGroundStation {
    private static final int SYSTEM = 254;
    private static final int COMPONENT = 190;
    private static final int AUTOPILOT = 1;
    private static final Duration PATIENCE = Duration.ofSeconds(10);

    private final Laboratory lab;
    private final LabDrone drone;
    private final int vehicle;
    private final LinkTap heard;
    private final FrameWriter writer = new FrameWriter(SYSTEM, COMPONENT, 2);
    private int looked;

    public DirectGroundStation(Laboratory lab, LabDrone drone) {
        this.lab = lab;
        this.drone = drone;
        this.vehicle = drone.vehicle().systemId();
        this.heard = drone.wire().tap();
    }

    private void say(Message message) {
        new FrameReader().read(ByteBuffer.wrap(writer.frame(message)), drone.vehicle()::receive);
    }

    /** The items of one kind of mission: 0 what is flown, 1 the fence, 2 rally points. */
    public List<MissionItemInt> mission(int kind) {
        int count = ask(
                        new MissionRequestList(vehicle, AUTOPILOT, kind),
                        MissionCount.ID,
                        MissionCount::decode,
                        answer -> answer.targetSystem() == SYSTEM && answer.missionType() == kind)
                .count();
        List<MissionItemInt> items = new ArrayList<>();
        for (int number = 0; number < count; number++) {
            int seq = number;
            items.add(ask(
                    new MissionRequestInt(vehicle, AUTOPILOT, seq, kind),
                    MissionItemInt.ID,
                    MissionItemInt::decode,
                    item -> item.targetSystem() == SYSTEM && item.seq() == seq && item.missionType() == kind));
        }
        return items;
    }

    /** Puts the mission that is there on board anew with one item higher, as any other ground station would. */
    public void raiseItem(int number, float meters) {
        List<MissionItemInt> items = mission(0);
        looked = heard.all().size();
        say(new MissionCount(vehicle, AUTOPILOT, items.size(), 0));
        int acknowledged = lab.until("the vehicle takes a mission of the station that is plugged in", PATIENCE, () -> {
            for (Frame frame : news()) {
                if (frame.messageId() == MissionAck.ID
                        && MissionAck.decode(frame).targetSystem() == SYSTEM) {
                    return Optional.of(MissionAck.decode(frame).type());
                }
                asked(frame).ifPresent(seq -> say(copy(items.get(seq), seq == number ? meters : 0)));
            }
            return Optional.empty();
        });
        if (acknowledged != 0) {
            throw new AssertionError("The vehicle does not take the mission: " + acknowledged);
        }
    }

    private static Optional<Integer> asked(Frame frame) {
        if (frame.messageId() == MissionRequestInt.ID) {
            return Optional.of(MissionRequestInt.decode(frame))
                    .filter(request -> request.targetSystem() == SYSTEM)
                    .map(MissionRequestInt::seq);
        }
        return frame.messageId() == MissionRequest.ID
                ? Optional.of(MissionRequest.decode(frame))
                        .filter(request -> request.targetSystem() == SYSTEM)
                        .map(MissionRequest::seq)
                : Optional.empty();
    }

    private MissionItemInt copy(MissionItemInt item, float higher) {
        return new MissionItemInt(
                vehicle,
                AUTOPILOT,
                item.seq(),
                item.frame(),
                item.command(),
                0,
                item.autocontinue(),
                item.param1(),
                item.param2(),
                item.param3(),
                item.param4(),
                item.x(),
                item.y(),
                item.z() + higher,
                0);
    }

    private List<Frame> news() {
        List<LinkTap.Heard> all = heard.all();
        List<Frame> news = all.subList(looked, all.size()).stream()
                .filter(LinkTap.Heard::up)
                .map(LinkTap.Heard::frame)
                .toList();
        looked = all.size();
        return news;
    }

    private <T> T ask(Message question, int answerId, Function<Frame, T> decoder, Predicate<T> fits) {
        looked = heard.all().size();
        say(question);
        return lab.until(
                "the vehicle answers the station that is plugged in",
                PATIENCE,
                () -> news().stream()
                        .filter(frame -> frame.messageId() == answerId)
                        .map(decoder)
                        .filter(fits)
                        .findFirst());
    }
}
