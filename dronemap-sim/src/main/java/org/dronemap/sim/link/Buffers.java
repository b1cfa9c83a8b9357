package org.dronemap.sim.link;

import java.nio.ByteBuffer;

/** The two byte buffers that all links of the simulated fleet share on its thread: one for input, one for output. */
record Buffers(ByteBuffer inbound, ByteBuffer outbound) {
    static Buffers allocate() {
        return new Buffers(ByteBuffer.allocateDirect(65_536), ByteBuffer.allocateDirect(2_048));
    }
}
