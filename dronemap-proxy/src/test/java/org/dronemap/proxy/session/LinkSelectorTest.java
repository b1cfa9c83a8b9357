package org.dronemap.proxy.session;

import static org.assertj.core.api.Assertions.assertThat;

import org.dronemap.core.access.LinkKey;
import org.dronemap.core.cloud.SendAuthority;
import org.dronemap.core.drone.DroneKey;
import org.dronemap.mavlink.Frame;
import org.dronemap.mavlink.FrameWriter;
import org.dronemap.mavlink.message.Heartbeat;
import org.dronemap.mavlink.message.SetupSigning;
import org.jspecify.annotations.Nullable;
import org.junit.jupiter.api.Test;

class LinkSelectorTest {
    private static final long SECOND = 1_000_000_000L;
    private static final Heartbeat BEAT = new Heartbeat(2, 3, 81, 4, 4, 3);

    private long now = 1_000 * SECOND;
    private final CapturingPeer udp = new CapturingPeer("udp", 1);
    private final CapturingPeer dtls = new CapturingPeer("dtls", 2);

    private VehicleLink link(CapturingPeer hop, @Nullable String identity) {
        DroneKey key = new DroneKey(hop.address().host(), hop.address().port(), 1);
        return new VehicleLink(
                new LinkOrigin(key, hop.transport(), false, false, identity),
                new VehicleSender(hop),
                CapturingPeer.frame(new FrameWriter(1, 1, 2), BEAT),
                () -> now);
    }

    /** A second of 20 messages, of which so many are lost. */
    private void brings(VehicleLink link, FrameWriter writer, int lost) {
        for (int i = 0; i < 20; i++) {
            Frame frame = CapturingPeer.frame(writer, BEAT);
            if (i >= lost) {
                link.arrived(frame);
            }
        }
    }

    @Test
    void speaksOnTheLinkThatLosesLessOnceItIsClearlyBetter() {
        VehicleLink first = link(udp, "alpha");
        VehicleLink second = link(dtls, "alpha");
        LinkSelector choice = new LinkSelector(first);
        choice.join(second);
        FrameWriter ofFirst = new FrameWriter(1, 1, 2);
        FrameWriter ofSecond = new FrameWriter(1, 1, 2);
        for (int i = 0; i < 10; i++) {
            brings(first, ofFirst, 0);
            brings(second, ofSecond, 0);
            choice.advance(now += SECOND);
        }
        assertThat(choice.best()).isSameAs(first);
        for (int i = 0; i < 10; i++) {
            brings(first, ofFirst, 10);
            brings(second, ofSecond, 0);
            choice.advance(now += SECOND);
        }
        assertThat(choice.best()).isSameAs(second);
        choice.send(BEAT);
        assertThat(dtls.heard()).hasSize(1);
        assertThat(udp.heard()).isEmpty();
        assertThat(choice.report().others()).containsExactly(first.key());
    }

    @Test
    void doesNotSwingBetweenLinksThatAreAboutAsGood() {
        VehicleLink first = link(udp, "alpha");
        VehicleLink second = link(dtls, "alpha");
        LinkSelector choice = new LinkSelector(first);
        choice.join(second);
        FrameWriter ofFirst = new FrameWriter(1, 1, 2);
        FrameWriter ofSecond = new FrameWriter(1, 1, 2);
        for (int i = 0; i < 20; i++) {
            brings(first, ofFirst, i % 2);
            brings(second, ofSecond, 0);
            choice.advance(now += SECOND);
            assertThat(choice.best()).isSameAs(first);
        }
    }

    @Test
    void leavesALinkThatFallsSilent() {
        VehicleLink first = link(udp, "alpha");
        VehicleLink second = link(dtls, "alpha");
        LinkSelector choice = new LinkSelector(first);
        choice.join(second);
        now += 2 * SECOND;
        brings(second, new FrameWriter(1, 1, 2), 0);
        choice.advance(now);
        assertThat(choice.best()).isSameAs(second);
    }

    @Test
    void sendsAKeyWhereNobodyCanListenWhicheverLinkIsBetter() {
        LinkSelector choice = new LinkSelector(link(udp, "alpha"));
        assertThat(choice.isSafe()).isFalse();
        choice.join(link(dtls, "alpha"));
        assertThat(choice.isSafe()).isTrue();

        choice.sendSecret(new SetupSigning(1, 1, new int[LinkKey.BYTES], 1));
        assertThat(udp.heard()).isEmpty();
        assertThat(dtls.heard()).extracting(Frame::messageId).containsExactly(SetupSigning.ID);
    }

    @Test
    void aLinkWithoutProofIsTheOnlyOne() {
        VehicleLink left = link(udp, null);
        VehicleLink joined = link(new CapturingPeer("udp", 3), null);
        LinkSelector choice = new LinkSelector(left);
        choice.join(joined);
        assertThat(choice.best()).isSameAs(joined);
        assertThat(choice.isRedundant()).isFalse();
        choice.send(BEAT);
        left.send(BEAT, SendAuthority.HOUSEKEEPING);
        assertThat(udp.heard()).isEmpty();
    }
}
