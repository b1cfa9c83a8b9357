package org.dronemap.mavlink.message;

import org.dronemap.mavlink.Frame;
import org.dronemap.mavlink.Message;
import org.dronemap.mavlink.PayloadWriter;

/** MAVLink message 1, raw fields as on the wire. Generated: see MessageGenerator. */
public record SysStatus(
        long onboardControlSensorsPresent,
        long onboardControlSensorsEnabled,
        long onboardControlSensorsHealth,
        int load,
        int voltageBattery,
        int currentBattery,
        int batteryRemaining,
        int dropRateComm,
        int errorsComm,
        int errorsCount1,
        int errorsCount2,
        int errorsCount3,
        int errorsCount4,
        long onboardControlSensorsPresentExtended,
        long onboardControlSensorsEnabledExtended,
        long onboardControlSensorsHealthExtended)
        implements Message {
    public static final int ID = 1;

    public static SysStatus decode(Frame frame) {
        return new SysStatus(
                frame.u32(0),
                frame.u32(4),
                frame.u32(8),
                frame.u16(12),
                frame.u16(14),
                frame.i16(16),
                frame.i8(30),
                frame.u16(18),
                frame.u16(20),
                frame.u16(22),
                frame.u16(24),
                frame.u16(26),
                frame.u16(28),
                frame.u32(31),
                frame.u32(35),
                frame.u32(39));
    }

    @Override
    public int messageId() {
        return ID;
    }

    @Override
    public void write(PayloadWriter out) {
        out.u32(onboardControlSensorsPresent);
        out.u32(onboardControlSensorsEnabled);
        out.u32(onboardControlSensorsHealth);
        out.u16(load);
        out.u16(voltageBattery);
        out.i16(currentBattery);
        out.u16(dropRateComm);
        out.u16(errorsComm);
        out.u16(errorsCount1);
        out.u16(errorsCount2);
        out.u16(errorsCount3);
        out.u16(errorsCount4);
        out.i8(batteryRemaining);
        out.u32(onboardControlSensorsPresentExtended);
        out.u32(onboardControlSensorsEnabledExtended);
        out.u32(onboardControlSensorsHealthExtended);
    }
}
