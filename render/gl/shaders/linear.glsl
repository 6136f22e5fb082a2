// Work groups in one row, however many: dispatches are two-dimensional only because OpenGL allows no
// more than 65535 groups along one axis.
uint linear_group() { return gl_WorkGroupID.y * gl_NumWorkGroups.x + gl_WorkGroupID.x; }
