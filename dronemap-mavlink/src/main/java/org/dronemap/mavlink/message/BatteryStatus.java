package org.dronemap.mavlink.message;

import org.dronemap.mavlink.Frame;
import org.dronemap.mavlink.Message;
import org.dronemap.mavlink.PayloadWriter;

/** MAVLink message 147, raw fields as on the wire. Generated: see MessageGenerator. */
@SuppressWarnings("ArrayRecordComponent")
public record BatteryStatus(
        int id,
        int batteryFunction,
        int type,
        int temperature,
        int[] voltages,
        int currentBattery,
        int currentConsumed,
        int energyConsumed,
        int batteryRemaining,
        int timeRemaining,
        int chargeState,
        int[] voltagesExt,
        int mode,
        long faultBitmask)
        implements Message {
    public static final int ID = 147;

    public static BatteryStatus decode(Frame frame) {
        return new BatteryStatus(
                frame.u8(32),
                frame.u8(33),
                frame.u8(34),
                frame.i16(8),
                frame.u16s(10, 10),
                frame.i16(30),
                frame.i32(0),
                frame.i32(4),
                frame.i8(35),
                frame.i32(36),
                frame.u8(40),
                frame.u16s(41, 4),
                frame.u8(49),
                frame.u32(50));
    }

    @Override
    public int messageId() {
        return ID;
    }

    @Override
    public void write(PayloadWriter out) {
        out.i32(currentConsumed);
        out.i32(energyConsumed);
        out.i16(temperature);
        out.u16s(voltages, 10);
        out.i16(currentBattery);
        out.u8(id);
        out.u8(batteryFunction);
        out.u8(type);
        out.i8(batteryRemaining);
        out.i32(timeRemaining);
        out.u8(chargeState);
        out.u16s(voltagesExt, 4);
        out.u8(mode);
        out.u32(faultBitmask);
    }
}
