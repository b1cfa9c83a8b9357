package org.dronemap.proxy.roslink.wire;

/** One ROSLink message from a robot: header and body. */
public record RoslinkPacket(RoslinkHeader header, RobotMessage message) {}
