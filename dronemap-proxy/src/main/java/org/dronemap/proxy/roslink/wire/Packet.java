package org.dronemap.proxy.roslink.wire;

/** One message of a robot. */
public record Packet(Header header, RobotMessage message) {}
