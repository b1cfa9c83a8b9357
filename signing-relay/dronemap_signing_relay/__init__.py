"""Signs for MAVLink tools that cannot, and checks what the server has signed for them."""
