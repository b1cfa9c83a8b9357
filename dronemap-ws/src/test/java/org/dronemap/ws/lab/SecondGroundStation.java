package org.dronemap.ws.lab;

import java.nio.ByteBuffer;
import java.util.List;
import org.dronemap.core.geo.Geodetic;
import org.dronemap.mavlink.Frame;
import org.dronemap.mavlink.FrameReader;
import org.dronemap.mavlink.FrameWriter;
import org.dronemap.mavlink.message.MissionAck;
import org.dronemap.mavlink.message.MissionCount;
import org.dronemap.mavlink.message.MissionItemInt;
import org.dronemap.mavlink.message.MissionRequest;
import org.dronemap.mavlink.message.MissionRequestInt;
import org.dronemap.proxy.endpoint.Peer;
import org.dronemap.proxy.endpoint.PeerCounters;
import org.dronemap.proxy.endpoint.PeerHandler;

/** Another ground station, where the server was before it crashed: gives a vehicle another mission. */
public final class SecondGroundStation implements PeerHandler.Factory {
    private static final int SYSTEM = 254;
    private static final int ABOVE_HOME = 3;
    private static final int WAYPOINT = 16;
    private static final double PER_DEGREE = 1e7;

    private final FrameWriter writer = new FrameWriter(SYSTEM, 190, 2);
    private final List<Geodetic> places;
    private final float meters;
    private boolean begun;
    private boolean done;

    /** The first place stands for home, as ArduPilot wants it. */
    SecondGroundStation(List<Geodetic> places, double meters) {
        this.places = List.copyOf(places);
        this.meters = (float) meters;
    }

    /** The vehicle took the mission. */
    public boolean isDone() {
        return done;
    }

    @Override
    public PeerHandler opened(Peer peer, PeerCounters counters) {
        FrameReader reader = new FrameReader();
        return new PeerHandler() {
            @Override
            public void received(ByteBuffer bytes) {
                reader.read(bytes, frame -> heard(peer, frame));
            }

            @Override
            public void closed() {
                // nothing is kept of a vehicle
            }
        };
    }

    private void heard(Peer peer, Frame frame) {
        if (!begun) {
            begun = true;
            peer.send(writer.frame(new MissionCount(frame.systemId(), 1, places.size(), 0)));
        } else if (frame.messageId() == MissionRequest.ID) {
            give(peer, frame.systemId(), MissionRequest.decode(frame).seq());
        } else if (frame.messageId() == MissionRequestInt.ID) {
            give(peer, frame.systemId(), MissionRequestInt.decode(frame).seq());
        } else if (frame.messageId() == MissionAck.ID) {
            done = MissionAck.decode(frame).type() == 0;
        }
    }

    private void give(Peer peer, int system, int number) {
        Geodetic place = places.get(number);
        int x = (int) Math.round(place.latitudeDegrees() * PER_DEGREE);
        int y = (int) Math.round(place.longitudeDegrees() * PER_DEGREE);
        peer.send(writer.frame(
                new MissionItemInt(system, 1, number, ABOVE_HOME, WAYPOINT, 0, 1, 0, 0, 0, 0, x, y, meters, 0)));
    }
}
