package org.dronemap.sim.link;

import java.nio.ByteBuffer;

/** The fleet thread's two buffers: an answer goes out while what asked for it is still being read. */
record Buffers(ByteBuffer inbound, ByteBuffer outbound) {
    static Buffers allocate() {
        return new Buffers(ByteBuffer.allocateDirect(65_536), ByteBuffer.allocateDirect(2_048));
    }
}
